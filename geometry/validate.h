#pragma once

#include <optional>
#include <string>

#include "geometry/mesh.h"

namespace dini {

/// The largest coordinate a mesh may hold, in meters: encoders fail beyond it.
inline constexpr double largest_coordinate = 1e18;

/// Whether a mesh, or a file, can hold a point: its coordinates are finite and below `largest_coordinate`.
bool is_within_reach(const Point& point);

/// The first broken invariant of a mesh as a sentence, or nothing when it keeps them all: attributes empty or one per
/// vertex, indices in range, no triangle that uses a vertex twice, finite positions below `largest_coordinate`, unit
/// normals (to 1e-6), finite texture coordinates and colors in [0, 1], `tile_ends` ascending up to the last triangle.
std::optional<std::string> mesh_defect(const Mesh& mesh);

}  // namespace dini
