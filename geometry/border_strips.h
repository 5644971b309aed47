#pragma once

#include "geometry/thicken.h"

namespace dini {

/// Meshes with fewer vertices have room for all corners of their strips, however much border they have.
inline constexpr std::size_t few_strip_vertices = 10'000;

/// Adds to the two sheets of a wall the strips that join them along the borders of the surface: two triangles for each
/// side. `front` and `back` are where the distinct positions went. The strips have vertices of their own, so that the
/// rim is an edge; along the border their normals are even where it bends by less than 40 degrees. Texture coordinates
/// and colors are those of the border. In large meshes that are nearly all border the strips share vertices at corners
/// too, so that they have at most two for each of the border's. Stopped early: a mesh that means nothing.
void add_border_strips(const WallSurface& surface, const std::vector<Vector>& front, const std::vector<Vector>& back,
                       Mesh& sheets, const Cancel& cancel);

}  // namespace dini
