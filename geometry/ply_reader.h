#pragma once

#include "geometry/imported_mesh.h"

namespace dini {

/// Reads a PLY 1.0, ascii or binary of either byte order. Of the element `vertex` it takes x y z, nx ny nz, the texture
/// coordinates (s t, u v, or texture_u texture_v) and red green blue alpha (0 to 255, 0 to 65535, or real numbers from
/// 0 to 1); of `face` the list vertex_indices or vertex_index, cut into triangles (geometry/polygon.h). Everything else
/// is passed over. Refused: numbers that are none or not finite, indices of no vertex, faces of fewer than three
/// corners, and files that are cut short. v of the texture is turned over, since PLY counts from the lower left.
ImportResult read_ply(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini
