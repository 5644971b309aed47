#pragma once

// Triangle meshes, polylines and point clouds: what a graph can draw.

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/column.h"
#include "geometry/shared.h"
#include "geometry/untouched.h"

namespace dini {

/// Linear red, green, blue, alpha in [0, 1].
using Color = std::array<double, 4>;

/// How a surface takes light, besides its color; as in glTF, metallic and roughness are in [0, 1].
struct Finish {
  double metallic = 0;
  double roughness = 0.6;
  bool double_sided = true;

  auto operator<=>(const Finish&) const = default;
};

/// An indexed triangle mesh in meters, Z up, counter-clockwise front faces.
/// `normals` (unit), `uvs` and `colors` are either empty or one per vertex. Every index is below `positions.size()`.
/// `tile_ends` cuts the triangle list into compact runs for encoding: ascending ends, the last equal to
/// `triangles.size()`; empty means one run. A copy shares all of these until it changes them.
struct Mesh {
  Shared<Column<Point>> positions;
  Shared<Column<Vector>> normals;
  Shared<NumberList<std::array<double, 2>>> uvs;
  Shared<NumberList<std::array<float, 4>>> colors;
  Shared<NumberList<std::array<std::uint32_t, 3>>> triangles;
  Shared<std::vector<std::size_t>> tile_ends;
  Color color = {0.75, 0.78, 0.82, 1};
  Finish finish = {};

  std::size_t bytes() const {
    return (*positions).bytes() + (*normals).bytes() + uvs.size() * sizeof(uvs[0]) + colors.size() * sizeof(colors[0]) +
           triangles.size() * sizeof(triangles[0]) + tile_ends.size() * sizeof(std::size_t);
  }
};

using SharedMesh = std::shared_ptr<const Mesh>;

/// A run of points joined by straight segments; `closed` joins the last to the first.
struct Polyline {
  Column<Point> points;
  bool closed = false;
};

}  // namespace dini
