#pragma once

#include <vector>

#include "geometry/welded_mesh.h"

namespace dini {

/// Where the vertices of a surface go that moves along its normals.
struct Displacements {
  /// For each distinct position: how it moves while its triangles move by 1 m along their normals.
  std::vector<Vector> directions;
  bool smooth = false;  ///< they are along the normals of the mesh, which has one at each position
};

/// The directions of a mesh that was welded. Where the mesh has one normal at each position they are along these: where
/// triangles are nearly even of length 1, so that the moved surface is the parallel one; at corners, and on meshes with
/// several normals at a position, as long as it takes for the planes of the triangles, weighted by their angles, so
/// that flat faces stay at even distances. At sharp tips at most `longest_miter`. Where triangles cancel it is the
/// normal of the first that has an area, or e3. Stopped early: meaningless.
Displacements displacements(const Mesh& mesh, const WeldedMesh& welded, const Cancel& cancel);

inline constexpr double longest_miter = 3;

/// The mesh moved by `distance` along its normals, below 0 against them: the same triangles. Positions may become so
/// large that no mesh holds them. Stopped early: meaningless.
Mesh offset(const Mesh& mesh, double distance, const Cancel& cancel);

}  // namespace dini
