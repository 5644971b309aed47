#pragma once

// A mesh as its surface is: vertices at exactly equal positions are one, and it is known where triangles end alone.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// Corners as indices, counter-clockwise seen from the front.
using Corners = std::array<std::uint32_t, 3>;

/// Stands for no vertex, and for no side: the largest number, which is one less than 0.
inline constexpr std::uint32_t none_of_them = 0xffffffff;

/// The triangles of a mesh between distinct positions.
struct WeldedMesh {
  std::vector<Vector> positions;         ///< those that triangles use, by the first vertex at each
  std::vector<Corners> triangles;        ///< those with three distinct corners, in the order of the mesh
  std::vector<std::uint32_t> vertex_of;  ///< for every vertex of the mesh; `none_of_them` where no triangle uses it
};

/// Welds a mesh. Linear time. Stopped early: an empty one.
WeldedMesh welded(const Mesh& mesh, const Cancel& cancel);

/// The first vertex of the mesh at each distinct position. Stopped early: of some.
std::vector<std::size_t> first_vertices(const WeldedMesh& mesh, const Cancel& cancel);

/// Where the sides of triangles do not lie against one another in pairs. Side 3 * t + k runs from corner k of triangle
/// t to the next one.
struct MeshSides {
  std::vector<std::uint32_t> borders;  ///< sides whose edge has no other triangle, ascending
  std::vector<std::uint32_t> faults;   ///< sides whose edge has more than two triangles, or two that run the same way
};

/// Finds the sides that lie against no other, or against too many. Stopped early: meaningless.
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

/// What keeps anything from being built along a surface or on its borders, in words: an edge with more than two
/// triangles, or with two that run the same way, or borders that meet in one vertex. Nothing where all is well.
std::optional<std::string> fault_of(const WeldedMesh& mesh, const MeshSides& sides, const BorderLoops& borders);

}  // namespace dini
