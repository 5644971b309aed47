#pragma once

#include "geometry/imported_mesh.h"

namespace dini {

/// Reads a Wavefront OBJ: `v` (with or without a color), `vt`, `vn` and `f`, whose indices may be negative. Every
/// combination of position, texture coordinate and normal that a face uses becomes a vertex, so seams are split.
/// Polygons are cut into triangles (geometry/polygon.h). Everything else, materials and other files among it, is passed
/// over. Refused with the line number: numbers that are none or not finite, faces of fewer than three corners, indices
/// that lead nowhere. v of the texture is turned over, since OBJ counts from the lower left.
ImportResult read_obj(std::string_view text, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini
