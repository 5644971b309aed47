#pragma once

#include <optional>
#include <string>

#include "geometry/imported_mesh.h"

namespace dini {

/// Whether bytes are an STL: as long as the number of triangles in a binary one says, or beginning with "solid", which
/// text does that is one, and binary ones of some programs do.
bool begins_like_stl(std::string_view bytes);

/// How long a binary STL would be by the count that stands where one has it, as a hint for files that are of no known
/// format: "a binary STL of 12 triangles has 684 bytes, this file 600". Nothing for files shorter than its header.
std::optional<std::string> stl_size_hint(std::string_view bytes);

/// Reads an STL, binary or text. Corners with exactly the same coordinates become one vertex, so that the mesh holds
/// together and its normals, which are computed, are smooth; those of the file, of its flat triangles, are not taken.
///
/// Left out with a counted warning: triangles with a corner twice, or with one that is not finite or beyond 1e18,
/// colors (the two bytes behind a triangle, which programs read in different ways), and what stands behind the last
/// triangle. Refused with the place: binary files that are shorter than they say, and text that is no STL.
ImportResult read_stl(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini
