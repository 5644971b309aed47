#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/vector.h"

namespace dini {

/// Cuts the polygons of one file into triangles. A convex polygon becomes a fan about its first corner. A concave one
/// of up to 128 corners, or as many as are asked for, is cut by ear clipping (Meisters, Polygons have ears, 1975), seen
/// along its mean normal; a larger one, one that crosses itself so that no ear is left, and what comes after the work
/// allowed for a file has been spent becomes a fan. A polygon of n corners always gives n - 2 triangles.
class PolygonCutter {
 public:
  /// Cuts concave polygons of up to so many corners by ear clipping.
  explicit PolygonCutter(std::size_t most_clipped_corners = 128) : most_clipped_corners_(most_clipped_corners) {}

  /// Adds the triangles as indices into `corners`, which has at least three.
  void cut(std::span<const Vector> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

 private:
  std::size_t most_clipped_corners_;
  std::size_t work_left_ = 20'000'000;  ///< tests of a corner against an ear
};

}  // namespace dini
