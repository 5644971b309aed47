#pragma once

// Places on a mesh, found by a tree of boxes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/bounding_box.h"
#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A place on a triangle, and how far it is from the point that was asked for.
struct MeshPlace {
  std::size_t triangle = 0;
  std::array<double, 3> weights = {};  ///< of the corners: at least 0, with sum 1
  Vector position;
  double squared_distance = 0;  ///< in square meters
};

/// The place on the triangle with these corners that is nearest to a point. Triangles without area are the segments or
/// the points that they look like. `triangle` of the answer is 0.
MeshPlace nearest_on_triangle(const std::array<Vector, 3>& corners, const Vector& point);

/// A bounding-volume tree over triangles. Building it takes n log n, asking it about log n.
class MeshTree {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// At least one triangle; every index is below `positions.size()`, every coordinate finite. Stopped early: its
  /// answers are meaningless.
  MeshTree(std::vector<Vector> positions, Triangles triangles, const Cancel& cancel);

  /// The same mesh gives the same place on every machine: of triangles at exactly equal distances, the one that the
  /// tree meets first. Any number of threads may ask at once.
  MeshPlace nearest(const Vector& point) const;

  /// Calls visit(triangle) for the triangles of all boxes that meet this one, until it answers false. Those of a leaf
  /// are asked for together, so some lie beside the box. In one order on every machine.
  template <class Visit>
  void visit_near(const BoundingBox& box, const Visit& visit) const;

  /// Calls visit(triangle, most) for the triangles of all boxes that a ray meets within `most` times the length of its
  /// direction; the answers are how far it is still of interest.
  template <class Visit>
  void visit_along(const Vector& origin, const Vector& direction, double most, const Visit& visit) const;

  const std::vector<Vector>& positions() const { return positions_; }
  const Triangles& triangles() const { return triangles_; }
  /// About how much memory it holds.
  std::size_t bytes() const;
  /// Of the front side of a triangle, of length 1; zero where it has no area.
  Vector normal(std::size_t triangle) const;

 private:
  /// A box around the triangles of `order_` in [begin, end). Its left child follows it; a leaf has none.
  struct Box {
    BoundingBox bounds;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t right = 0;  ///< 0 for a leaf
  };

  std::array<Vector, 3> corners(std::size_t triangle) const;
  Box box_around(std::uint32_t begin, std::uint32_t end) const;

  /// Visits the boxes that `enter` lets in, parents first, and the triangles of leaves until `visit` answers false.
  template <class Enter, class Visit>
  void descend(const Enter& enter, const Visit& visit) const;

  /// Halving up to 2^32 triangles opens no more boxes than this at once.
  static constexpr std::size_t most_open = 64;

  std::vector<Vector> positions_;
  Triangles triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

template <class Enter, class Visit>
void MeshTree::descend(const Enter& enter, const Visit& visit) const {
  std::array<std::uint32_t, most_open> open;
  std::size_t count = 0;
  if (!boxes_.empty()) open[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const Box& box = boxes_[index];
    if (!enter(box)) continue;
    if (box.right != 0) {
      open[count++] = box.right;
      open[count++] = index + 1;
      continue;
    }
    for (std::uint32_t i = box.begin; i < box.end; ++i) {
      if (!visit(order_[i])) return;
    }
  }
}

template <class Visit>
void MeshTree::visit_near(const BoundingBox& box, const Visit& visit) const {
  descend([&](const Box& inner) { return inner.bounds.meets(box); }, visit);
}

template <class Visit>
void MeshTree::visit_along(const Vector& origin, const Vector& direction, double most, const Visit& visit) const {
  const auto within = [&](double from, double step, double low, double high, double& begin, double& end) {
    if (step == 0) return low <= from && from <= high;
    const double first = (low - from) / step, second = (high - from) / step;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
    return true;
  };
  descend(
      [&](const Box& box) {
        double begin = 0, end = most;
        return within(origin.x, direction.x, box.bounds.low.x, box.bounds.high.x, begin, end) &&
               within(origin.y, direction.y, box.bounds.low.y, box.bounds.high.y, begin, end) &&
               within(origin.z, direction.z, box.bounds.low.z, box.bounds.high.z, begin, end) &&
               begin <= end + 1e-9 * (end + most);  // round-off of either
      },
      [&](std::uint32_t triangle) {
        most = visit(triangle, most);
        return true;
      });
}

}  // namespace dini
