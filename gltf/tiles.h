#pragma once

// Cutting meshes into tiles that are compressed, and later decoded, in parallel.

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/mesh.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// Triangles of one tile: about 128 x 128 quads. Smaller tiles repeat more vertices along their borders (36 tiles of
/// this size add 2-3 % of bytes to a mesh of a million triangles), larger ones leave threads idle.
inline constexpr std::size_t tile_triangles = 32768;

/// No tile has more triangles than this.
inline constexpr std::size_t largest_tile_triangles = tile_triangles + tile_triangles / 2;

/// The ends of the runs of triangles that become tiles. Given runs (`mesh.tile_ends`, or the whole mesh) that are too
/// long are cut into equal runs; small neighbors are joined while they stay small enough. Depends on the mesh only.
std::vector<std::size_t> plan_tiles(const Mesh& mesh);

/// The first broken promise of `geometry/mesh.h`, if any: sizes of the attribute arrays, order of `tile_ends`.
std::optional<EncodeError> check_mesh(const Mesh& mesh);

/// Triangles [begin, end) as a compact mesh: vertices renumbered in the order of first use, triangles with a repeated
/// index left out, so the tile can be empty. Zero or non-finite normals become the z axis.
/// Errors: `non_finite`, `too_large` (beyond 1e18) for a used position or texture coordinate, `invalid_input` for an
/// index out of range.
EncodeResult<Tile> build_tile(const Mesh& mesh, std::size_t begin, std::size_t end, const EncodeOptions& options);

}  // namespace dini
