#include "draco/corner_table.h"

#include <catch2/catch.hpp>

#include "tests/draco/grids.h"

using namespace dini;

namespace {

using List = std::vector<std::array<std::uint32_t, 3>>;

bool is_manifold(const List& triangles, std::size_t vertices) {
  return CornerTable::of(triangles, vertices).has_value();
}

TEST_CASE("Opposite corners face the same edge from both sides") {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const grids::TriangleList list = grids::any(12, random);
    const auto table = CornerTable::of(list.triangles, list.vertices);
    if (!table) continue;
    for (Corner corner = 0; corner < table->corners(); ++corner) {
      const Corner across = table->opposite(corner);
      if (across == absent) continue;
      REQUIRE(table->opposite(across) == corner);
      REQUIRE(table->vertex(next(across)) == table->vertex(previous(corner)));
      REQUIRE(table->vertex(previous(across)) == table->vertex(next(corner)));
    }
  }
}

TEST_CASE("A vertex is on the boundary when an edge of it has one side") {
  std::mt19937 random(2);
  const grids::TriangleList tube = grids::grid(4, 5, grids::Wrap::columns, random);
  const auto table = CornerTable::of(tube.triangles, tube.vertices);
  REQUIRE(table);
  for (std::uint32_t vertex = 0; vertex < tube.vertices; ++vertex) {
    CHECK(table->on_boundary(vertex) == (vertex < 5 || vertex >= 15));
  }
}

TEST_CASE("What is no manifold has no table") {
  const List quad = {{0, 1, 2}, {2, 1, 3}};
  CHECK(is_manifold(quad, 4));
  CHECK_FALSE(is_manifold({{0, 1, 2}, {2, 1, 3}, {1, 2, 4}}, 5));  // three triangles at an edge
  CHECK_FALSE(is_manifold({{0, 1, 2}, {1, 2, 3}}, 4));             // turned the other way around
  CHECK_FALSE(is_manifold({{0, 1, 2}, {0, 1, 2}}, 3));             // twice the same
  CHECK_FALSE(is_manifold({{0, 1, 2}, {0, 3, 4}}, 5));             // two fans at a vertex
  CHECK_FALSE(is_manifold({{0, 1, 2}, {0, 2, 1}}, 3));             // both sides of a triangle
  CHECK_FALSE(is_manifold({{0, 1, 2}, {2, 1, 1}}, 3));             // a vertex twice in a triangle
  CHECK_FALSE(is_manifold({{0, 0, 0}}, 1));
  CHECK_FALSE(is_manifold(quad, 5));  // a vertex of no triangle
}

TEST_CASE("A fan around one vertex is found however large it is") {
  constexpr std::uint32_t rim = 20000;
  List fan;
  for (std::uint32_t i = 0; i < rim; ++i) fan.push_back({0, 1 + i, 1 + (i + 1) % rim});
  const auto table = CornerTable::of(fan, rim + 1);
  REQUIRE(table);
  CHECK_FALSE(table->on_boundary(0));
}

}  // namespace
