#include "geometry/point_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <tuple>
#include <vector>

#include "tests/support/random_elements.h"

using namespace dini;

namespace {

struct PlaceColumns {
  std::vector<double> x, y, z;

  void add(const Vector& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  std::size_t size() const { return x.size(); }
  kernels::ConstPoints points() const { return {x.data(), y.data(), z.data()}; }
  double square(std::size_t i, std::size_t j) const {
    const double a = x[j] - x[i], b = y[j] - y[i], c = z[j] - z[i];
    return a * a + b * b + c * c;
  }
};

/// What a search finds that looks at every point.
std::vector<std::uint32_t> plain_search(const PlaceColumns& places, std::size_t i, std::size_t wanted) {
  std::vector<std::uint32_t> others;
  for (std::size_t j = 0; j < places.size(); ++j) {
    if (j != i) others.push_back(static_cast<std::uint32_t>(j));
  }
  std::sort(others.begin(), others.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(places.square(i, a), a) < std::tuple(places.square(i, b), b);
  });
  others.resize(wanted, static_cast<std::uint32_t>(i));
  return others;
}

void require_right(const PlaceColumns& places, std::size_t wanted) {
  const Cancel cancel;
  const PointTree tree(places.points(), places.size(), cancel);
  REQUIRE(tree.size() == places.size());
  std::vector<std::uint32_t> found(wanted), seen;
  for (std::size_t place = 0; place < places.size(); ++place) {
    const std::uint32_t i = tree.in_order(place);
    seen.push_back(i);
    tree.find_nearest(place, found);
    REQUIRE(found == plain_search(places, i, wanted));
  }
  std::sort(seen.begin(), seen.end());
  for (std::size_t i = 0; i < seen.size(); ++i) REQUIRE(seen[i] == i);
}

}  // namespace

TEST_CASE("The nearest points of a tree are those that a search over all finds") {
  RandomElements random(61);
  for (const std::size_t size : {1, 2, 12, 13, 25, 100, 260}) {
    PlaceColumns even, flat, grid;
    for (std::size_t i = 0; i < size; ++i) {
      even.add(random.vector());
      flat.add({random.number(), 0, 1e-9 * random.number()});
      // Many at one distance, and some at one place.
      grid.add({static_cast<double>(i % 5), static_cast<double>(i / 5 % 4), static_cast<double>(i / 20 % 3)});
    }
    for (const std::size_t wanted : {1, 6, 64}) {
      CAPTURE(size, wanted);
      require_right(even, wanted);
      require_right(flat, wanted);
      require_right(grid, wanted);
    }
  }
}

TEST_CASE("A tree of more points than one thread splits finds the nearest too") {
  RandomElements random(62);
  PlaceColumns places;
  for (int i = 0; i < 9000; ++i) places.add(random.vector());
  const Cancel cancel;
  const PointTree tree(places.points(), places.size(), cancel);
  std::vector<std::uint32_t> found(6);
  for (std::size_t place = 0; place < places.size(); place += 397) {
    tree.find_nearest(place, found);
    REQUIRE(found == plain_search(places, tree.in_order(place), 6));
  }
}
