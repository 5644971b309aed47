#include "draco/edgebreaker.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "draco/valence_contexts.h"
#include "draco/vertex_order.h"
#include "tests/draco/grids.h"

using namespace dini;

namespace {

template <class Check>
void for_random_manifolds(Check check) {
  std::mt19937 random(3);
  int manifolds = 0;
  for (int i = 0; i < 200; ++i) {
    const grids::TriangleList list = grids::any(12, random);
    const auto table = CornerTable::of(list.triangles, list.vertices);
    if (!table) continue;
    ++manifolds;
    check(*table, edgebreaker(*table));
  }
  REQUIRE(manifolds > 50);
}

TEST_CASE("The walk meets every triangle once, with a symbol or as the first of a closed piece") {
  for_random_manifolds([](const CornerTable& table, const Edgebreaker& walk) {
    std::set<Corner> met;
    for (const Corner corner : walk.corners) met.insert(corner / 3);
    for (const Corner corner : walk.closing) met.insert(corner / 3);
    CHECK(met.size() == table.triangles());
    CHECK(walk.symbols.size() + walk.closing.size() == table.triangles());
    CHECK(walk.corners.size() == walk.symbols.size());
    CHECK(static_cast<std::size_t>(std::count(walk.closed.begin(), walk.closed.end(), true)) == walk.closing.size());
  });
}

// A decoder makes three vertices for each e, one for each l and r, and joins two for each s.
TEST_CASE("The symbols make as many vertices as there are") {
  for_random_manifolds([](const CornerTable& table, const Edgebreaker& walk) {
    const auto count = [&](Symbol symbol) { return std::count(walk.symbols.begin(), walk.symbols.end(), symbol); };
    const auto vertices = 3 * count(Symbol::e) + count(Symbol::l) + count(Symbol::r) - count(Symbol::s);
    CHECK(vertices == static_cast<std::ptrdiff_t>(table.vertices()));
  });
}

TEST_CASE("The contexts hold all symbols but the first that is decoded") {
  for_random_manifolds([](const CornerTable& table, const Edgebreaker& walk) {
    std::size_t symbols = 0;
    for (const auto& context : valence_contexts(table, walk)) symbols += context.size();
    CHECK(symbols + 1 == walk.symbols.size());
    CHECK(walk.symbols.back() == Symbol::e);
  });
}

TEST_CASE("Each vertex is decoded once, from vertices decoded before") {
  for_random_manifolds([](const CornerTable& table, const Edgebreaker& walk) {
    const VertexOrder order = vertex_order(table, walk);
    std::set<std::uint32_t> known;
    for (std::size_t i = 0; i < order.vertices.size(); ++i) {
      const auto& [after, before, across] = order.parallelograms[i];
      for (const std::uint32_t vertex : {after, before, across}) CHECK((i == 0 || known.contains(vertex)));
      CHECK(known.insert(order.vertices[i]).second);
    }
    CHECK(known.size() == table.vertices());
  });
}

}  // namespace
