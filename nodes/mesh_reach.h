#pragma once

#include "geometry/mesh.h"

namespace dini {

/// The least distance that the coordinates of a mesh tell from none, in meters.
double least_change(const Mesh& mesh);

/// Whether all positions of a mesh are such that a mesh can hold them.
bool is_mesh_within_reach(const Mesh& mesh);

}  // namespace dini
