#include "geometry/mesh_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace dini;

namespace {

struct Cloud {
  std::mt19937 random{7};
  double number(double size) { return std::uniform_real_distribution<double>(-size, size)(random); }
  Vector point(double size) { return {number(size), number(size), number(size)}; }
};

/// Triangles anywhere, some of them without area.
MeshTree soup(Cloud& cloud, std::size_t count, double size) {
  std::vector<Vector> positions;
  MeshTree::Triangles triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector corner = cloud.point(1);
    positions.insert(positions.end(), {corner, corner + cloud.point(size), corner + cloud.point(size)});
    if (i % 7 == 0) positions.back() = positions[positions.size() - 2];
    if (i % 31 == 0) positions.back() = positions[positions.size() - 2] = corner;
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return {std::move(positions), std::move(triangles), Cancel()};
}

}  // namespace

TEST_CASE("The nearest place of a tree is the nearest of all triangles, looked at one by one") {
  Cloud cloud;
  for (const std::size_t count : {1, 2, 5, 64, 1000}) {
    const MeshTree tree = soup(cloud, count, 0.3);
    for (int k = 0; k < 300; ++k) {
      const Vector point = cloud.point(2);
      double least = 1e300;
      for (const auto& [a, b, c] : tree.triangles()) {
        const auto& corners = tree.positions();
        least = std::min(least, nearest_on_triangle({corners[a], corners[b], corners[c]}, point).squared_distance);
      }
      const MeshPlace place = tree.nearest(point);
      CHECK(place.squared_distance == least);
      const auto& [a, b, c] = tree.triangles()[place.triangle];
      const Vector again = place.weights[0] * tree.positions()[a] + place.weights[1] * tree.positions()[b] +
                           place.weights[2] * tree.positions()[c];
      CHECK(length(again - place.position) < 1e-15);
    }
  }
}

TEST_CASE("No place of a triangle is nearer than the nearest one") {
  Cloud cloud;
  for (int k = 0; k < 2000; ++k) {
    std::array<Vector, 3> corners = {cloud.point(1), cloud.point(1), cloud.point(1)};
    if (k % 5 == 0) corners[2] = 0.5 * (corners[0] + corners[1]);  // a segment
    if (k % 11 == 0) corners[1] = corners[2] = corners[0];         // a point
    const Vector point = cloud.point(2);
    const MeshPlace place = nearest_on_triangle(corners, point);
    for (const double weight : place.weights) CHECK(weight >= 0);
    CHECK(place.weights[0] + place.weights[1] + place.weights[2] == Approx(1));
    for (int i = 0; i < 20; ++i) {
      const double u = 0.5 + 0.5 * cloud.number(1), v = (1 - u) * (0.5 + 0.5 * cloud.number(1));
      const Vector other = (1 - u - v) * corners[0] + u * corners[1] + v * corners[2];
      CHECK(squared_length(point - other) >= place.squared_distance - 1e-14);
    }
  }
}

TEST_CASE("A tree of many triangles at one place still ends, and names one of them") {
  std::vector<Vector> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const MeshTree tree(positions, MeshTree::Triangles(5000, {0, 1, 2}), Cancel());
  const MeshPlace place = tree.nearest({0.25, 0.25, 2});
  CHECK(place.squared_distance == 4);
  CHECK(place.position == Vector{0.25, 0.25, 0});
  CHECK(tree.normal(place.triangle) == Vector{0, 0, 1});
}
