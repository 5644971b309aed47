#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A coarse stand-in for a mesh, with at most so many triangles: vertices that share a cell of a grid become the first
/// of them (vertex clustering: Rossignac and Borrel, "Multi-resolution 3D approximations", 1993), in the finest grid
/// that keeps to the number. Vertices keep their normals, texture coordinates and colors. For drafts: it is quick,
/// takes any triangles, and gives the same bits everywhere, but rounds off what is smaller than a cell. A mesh that has
/// no more triangles comes back as it is; of one with area something is left, even when that is more than was asked
/// for. Stopped early: not a whole mesh.
Mesh decimate(const Mesh& mesh, std::size_t triangles, const Cancel& cancel);

}  // namespace dini
