#pragma once

#include "geometry/grid_normals.h"
#include "geometry/surface_vertices.h"

namespace dini {

/// Sets the normals of a surface where those by differences are in doubt: there they are looked for again with what is
/// known now, and where there is none or it disagrees with the triangles, it is taken from the triangles around the
/// vertex, weighted by angle. `doubtful` is by sample; cuts are always in doubt.
void settle_normals(const GridSamples& samples, const GridNormals& by_differences,
                    const std::vector<SurfaceTile>& tiles, const SurfaceVertices& vertices,
                    const Zeroed<std::uint8_t>& doubtful, Mesh& mesh, const Cancel& cancel);

}  // namespace dini
