#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// The mesh with every triangle cut into four at the middles of its edges, `levels` times. The shape stays; normals,
/// texture coordinates and colors are averaged along edges. Neighbors with equal corner positions get equal middles, so
/// no seam opens. The result must have fewer than 2^32 vertices. Stopped early: the level reached so far, or an empty
/// mesh.
Mesh subdivide(const Mesh& mesh, std::size_t levels, const Cancel& cancel);

}  // namespace dini
