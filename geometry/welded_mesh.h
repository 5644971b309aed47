#pragma once

// A mesh as its surface is: vertices at exactly equal positions are one, and every side of a triangle knows the one
// that lies against it.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// Corners as indices, counter-clockwise seen from the front.
using Corners = std::array<std::uint32_t, 3>;

/// Stands for no vertex, and for no side.
inline constexpr std::uint32_t none_of_them = 0xffffffff;

/// The triangles of a mesh between distinct positions.
struct WeldedMesh {
  std::vector<Vector> positions;         ///< those that triangles use, by the first vertex at each
  std::vector<Corners> triangles;        ///< those with three distinct corners, in the order of the mesh
  std::vector<std::uint32_t> vertex_of;  ///< for every vertex of the mesh; `none_of_them` where no triangle uses it
};

/// Welds a mesh. Linear time. Stopped early: an empty one.
WeldedMesh welded(const Mesh& mesh, const Cancel& cancel);

/// How the sides of triangles lie against one another. Side 3 * t + k runs from corner k of triangle t to the next one.
struct MeshSides {
  /// For every side the one that runs along the same edge the other way; `none_of_them` at borders and faults.
  std::vector<std::uint32_t> opposite;
  std::size_t edges = 0;
  std::vector<std::uint32_t> borders;  ///< sides whose edge has no other triangle, ascending
  std::vector<std::uint32_t> faults;   ///< sides whose edge has more than two triangles, or two that run the same way
};

/// Finds the sides that lie against one another. Stopped early: meaningless.
MeshSides sides_of(const std::vector<Corners>& triangles, std::size_t vertices, const Cancel& cancel);

/// The corner at which a side begins, and the one at which it ends.
inline std::uint32_t start_of(const std::vector<Corners>& triangles, std::uint32_t side) {
  return triangles[side / 3][side % 3];
}
inline std::uint32_t end_of(const std::vector<Corners>& triangles, std::uint32_t side) {
  return triangles[side / 3][(side % 3 + 1) % 3];
}

/// The borders of a surface as closed loops of sides, each with its triangles on the left.
struct BorderLoops {
  std::vector<std::vector<std::uint32_t>> loops;  ///< from the lowest side on, by their lowest sides
  std::optional<std::uint32_t> pinched;           ///< a vertex where borders meet, so that no loops can be told apart
};

/// Follows the borders. A surface without faults has as many of them begin as end at every vertex.
BorderLoops border_loops(const WeldedMesh& mesh, const MeshSides& sides, const Cancel& cancel);

}  // namespace dini
