#pragma once

// Cutting meshes into tiles that are compressed, and later decoded, in parallel.

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/mesh.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// Long runs of triangles are cut into tiles of at most this size. Smaller tiles repeat more vertices along their
/// borders and start more entropy tables, larger ones leave threads idle, here and in the browser.
inline constexpr std::size_t tile_triangles = 49152;

/// No tile has more triangles than this: two squares of 128 x 128 quads are joined, three are not.
inline constexpr std::size_t largest_tile_triangles = 65536;

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
