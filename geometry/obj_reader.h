#pragma once

#include "geometry/imported_mesh.h"

namespace dini {

/// Reads a Wavefront OBJ: `v` (with or without a color), `vt`, `vn` and `f`, whose indices may be negative. Every
/// combination of position, texture coordinate and normal that a face uses becomes a vertex, so seams are split.
/// Polygons are cut into triangles (geometry/polygon.h). v of the texture is turned over, since OBJ counts from the
/// lower left.
///
/// Left out with a counted warning: faces of fewer than three corners or with a vertex that is not finite (see
/// geometry/raw_mesh.h for other attributes), points, lines, free-form curves and surfaces, materials, weights of
/// vertices, and lines of no known kind. Names, groups and smoothing groups change no triangle and are passed over; no
/// other file is opened. Refused with the line: words that are no numbers, too few or too many of them, and indices
/// that lead nowhere.
ImportResult read_obj(std::string_view text, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini
