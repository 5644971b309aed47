#include "draco/topology_cache.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/draco/grids.h"

using namespace dini;

namespace {

grids::TriangleList random_grid(std::size_t rows, std::size_t columns) {
  std::mt19937 random(static_cast<unsigned>(rows * 100 + columns));
  return grids::grid(rows, columns, grids::Wrap::none, random);
}

TEST_CASE("A topology is found again by its triangles") {
  TopologyCache cache(1 << 20);
  const grids::TriangleList list = random_grid(10, 10);
  const auto first = cache.topology(list.triangles, list.vertices);
  REQUIRE(first != nullptr);
  CHECK(cache.topology(list.triangles, list.vertices) == first);
  CHECK(cache.size() == first->size());
  cache.clear();
  CHECK(cache.size() == 0);
  CHECK(cache.topology(list.triangles, list.vertices)->connectivity == first->connectivity);
}

// Only a few triangles make the key, so lists that differ in one triangle have one key.
TEST_CASE("Nearly equal lists are told apart") {
  TopologyCache cache(1 << 24);
  grids::TriangleList list = random_grid(20, 20);
  const auto first = cache.topology(list.triangles, list.vertices);
  for (std::size_t i = 0; i < list.triangles.size(); ++i) {
    auto turned = list.triangles;
    std::rotate(turned[i].begin(), turned[i].begin() + 1, turned[i].end());
    const auto other = cache.topology(turned, list.vertices);
    REQUIRE(other->triangles == turned);
  }
  CHECK(cache.topology(list.triangles, list.vertices)->connectivity == first->connectivity);
}

TEST_CASE("The least recently used leave when it is full") {
  const grids::TriangleList a = random_grid(10, 10), b = random_grid(10, 11), c = random_grid(11, 10);
  const std::size_t one = tile_topology(a.triangles, a.vertices)->size();
  TopologyCache cache(5 * one / 2);
  const auto first = cache.topology(a.triangles, a.vertices);
  const auto second = cache.topology(b.triangles, b.vertices);
  CHECK(cache.topology(a.triangles, a.vertices) == first);
  cache.topology(c.triangles, c.vertices);
  CHECK(cache.size() <= 5 * one / 2);
  CHECK(cache.topology(a.triangles, a.vertices) == first);
  CHECK(cache.topology(b.triangles, b.vertices) != second);
}

TEST_CASE("Nothing is kept without memory, and what is no manifold never") {
  TopologyCache none(0);
  const grids::TriangleList list = random_grid(5, 5);
  CHECK(none.topology(list.triangles, list.vertices) != nullptr);
  CHECK(none.size() == 0);
  TopologyCache cache(1 << 20);
  const std::vector<std::array<std::uint32_t, 3>> twice = {{0, 1, 2}, {0, 1, 2}};
  CHECK(cache.topology(twice, 3) == nullptr);
  CHECK(cache.size() == 0);
}

}  // namespace
