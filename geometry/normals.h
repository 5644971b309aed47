#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// Unit normals of every vertex from the triangles around it, each weighted by its angle at the vertex. Vertices at
/// exactly equal positions share one normal, so texture seams do not show. A vertex of no triangle, or whose triangles
/// cancel, gets e3. Used where a parametrization is not known, for example after a warp. Stopped early: normals that
/// mean nothing.
Column<Vector> smooth_normals(const Mesh& mesh, const Cancel& cancel);

}  // namespace dini
