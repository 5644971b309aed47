#pragma once

#include <optional>
#include <string>

#include "geometry/displacement.h"

namespace dini {

/// A wall along a surface, in meters.
struct Wall {
  double front = 0;            ///< how far it reaches along the normals, at least 0
  double back = 0.1;           ///< and against them; not both 0
  std::vector<double> shares;  ///< a factor of both for each distinct position, in the order of welding; empty: 1
};

/// Where a wall passes through itself.
struct WallContact {
  Vector place;     ///< the middle of a triangle that does
  double fits = 0;  ///< the share of the wall, in [0, 1), that would not; 0 where the surface itself does
};

/// A surface that walls are made along, welded once.
struct WallSurface {
  Mesh mesh;
  WeldedMesh welded;
  MeshSides sides;
  BorderLoops borders;
  Displacements moves;
  /// What makes a wall impossible, in words: an edge with more than two triangles, or with two that run the same way,
  /// or borders that meet in one vertex. Nothing where it is possible.
  std::optional<std::string> fault;
};
WallSurface wall_surface(const Mesh& mesh, const Cancel& cancel);

/// The wall along a surface without a fault: the surface moved to its front, the same moved to its back and turned
/// around, and strips along borders. Each edge has two triangles, and V - E + F is twice that of the surface. Vertices
/// that the mesh doubles along seams stay doubled. The sheets keep the normals of a smooth surface where the wall is
/// even, else theirs are computed. A mesh without triangles gives an empty mesh. Stopped early: an empty mesh.
Mesh wall_along(const WallSurface& surface, const Wall& wall, const Cancel& cancel);

/// The first place where a wall meets itself, or where it reaches beyond the center of a bend, so that a triangle is
/// turned around; and what share of it would fit, found by halving to about a thousandth. Takes n log n, some ten times
/// where there is contact. Stopped early: perhaps nothing.
std::optional<WallContact> contact_of(const WallSurface& surface, const Wall& wall, const Cancel& cancel);

}  // namespace dini
