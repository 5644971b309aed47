#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// The least distance that the coordinates of a mesh tell from none, in meters. Stopped early: less.
double least_change(const Mesh& mesh, const Cancel& cancel);

/// Whether all positions of a mesh are such that a mesh can hold them. Stopped early: whether some are.
bool is_mesh_within_reach(const Mesh& mesh, const Cancel& cancel);

}  // namespace dini
