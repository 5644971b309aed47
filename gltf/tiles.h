#pragma once

// Cutting meshes into tiles that are compressed, and later decoded, in parallel.

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// How large tiles are, in triangles. Smaller ones repeat more vertices along their borders and start more entropy
/// tables, larger ones leave threads idle, here and in the browser. Compressing one cannot be interrupted, so where
/// that is slow (speeds below 4) they are half as large: no call takes more than some 50 ms.
struct TileSizes {
  std::size_t usual = 49152;    ///< that long runs of triangles are cut to, at most
  std::size_t largest = 65536;  ///< two squares of 128 x 128 quads are joined, three are not
};
TileSizes tile_sizes(const EncodeOptions& options);

/// Bound on how far a channel of a color, from 0 to 1, is rounded: half a step of 1/4096, of which 4096 are 65535.
inline constexpr double color_error = 0.5 / 4096 + 1.0 / 65536;

/// The ends of the runs of triangles that become tiles. Given runs (`mesh.tile_ends`, or the whole mesh) that are too
/// long are cut into equal runs; small neighbors are joined while they stay small enough. Depends on the mesh and the
/// sizes only.
std::vector<std::size_t> plan_tiles(const Mesh& mesh, const TileSizes& sizes);

/// The first broken promise of `geometry/mesh.h`, if any: sizes of the attribute arrays, order of `tile_ends`.
std::optional<EncodeError> check_mesh(const Mesh& mesh);

/// Triangles [begin, end) as a compact mesh: vertices renumbered in the order of first use, triangles with a repeated
/// index left out, so the tile can be empty. Zero or non-finite normals become the z axis.
/// Errors: `non_finite`, `too_large` (beyond 1e18) for a used position or texture coordinate, `invalid_input` for an
/// index out of range, `canceled`.
EncodeResult<Tile> build_tile(const Mesh& mesh, std::size_t begin, std::size_t end, const EncodeOptions& options,
                              const Cancel& cancel);

}  // namespace dini
