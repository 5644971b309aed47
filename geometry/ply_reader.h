#pragma once

#include "geometry/imported_mesh.h"

namespace dini {

/// Reads a PLY 1.0, ascii or binary of either byte order. Of the element `vertex` it takes x y z, nx ny nz, the texture
/// coordinates (s t, u v, or texture_u texture_v) and the color (red green blue alpha, r g b a, or diffuse_red and so
/// on; see geometry/ply_meaning.h); of `face` the list vertex_indices or vertex_index, cut into triangles
/// (geometry/polygon.h), and a color, where the vertices have none; of `tristrips` the same list, in which -1 begins
/// another strip. Full light of a color is 255, 65535 or 1, by the type or by the largest value of the file
/// (geometry/file_colors.h). v of the texture is turned over, since PLY counts from the lower left.
///
/// Left out with a counted warning: other elements and properties, which are not even read as numbers, faces of fewer
/// than three corners or with a vertex that is not finite (see geometry/raw_mesh.h for other attributes), and what
/// stands behind the last element. Refused with the place: words that are no numbers, indices of no vertex, rows that
/// do not fit the header, and files that are cut short.
ImportResult read_ply(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini
