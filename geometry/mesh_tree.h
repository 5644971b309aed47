#pragma once

// The nearest place on a mesh, by a tree of boxes.

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

  std::vector<Vector> positions_;
  Triangles triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

}  // namespace dini
