#pragma once

#include <optional>
#include <string_view>

#include "geometry/scene.h"

namespace dini {

/// Reads back a file of `encode_scene`, for tests, measurements and comparisons. Only for files this program made: it
/// is no importer and must not see bytes that others made; a damaged file of ours is refused. Positions are those
/// stored, Z up, in meters; each part carries its material's color; each tile is a run of `tile_ends`; a polyline that
/// returns to its first point is closed. Nothing if the file is broken.
std::optional<Scene> read_glb(std::string_view glb);

}  // namespace dini
