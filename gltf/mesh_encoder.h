#pragma once

// The seam between tiles and a compressor: anything that turns one tile into Draco bytes can stand here.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gltf/encode_error.h"
#include "gltf/encode_options.h"
#include "gltf/quantization.h"

namespace dini {

/// A compact piece of a mesh, checked and ready to compress: every coordinate finite and inside the grids, every vertex
/// used, every triangle with three different indices below `positions.size()`. `normals` (never zero), `uvs` and
/// `colors` (linear, 65535 is 1) are empty or one per vertex.
struct Tile {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::array<std::uint16_t, 4>> colors;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  FloatBox position_box;
  FloatBox uv_box;  ///< third axis 0
};

/// The grids of a tile: that of the scene for positions, that of its part for texture coordinates (third axis unused).
struct TileGrids {
  QuantizationGrid positions;
  QuantizationGrid uvs;
};

/// A compressed tile. The counts are those of the decoded tile: compressing may split vertices.
/// The attribute ids are -1 when the tile has no such attribute.
struct EncodedTile {
  std::vector<char> bytes;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  int position_id = -1;
  int normal_id = -1;
  int uv_id = -1;
  int color_id = -1;
};

/// Compresses tiles. Called from several threads at once; never throws; the same tile gives the same bytes.
class MeshEncoder {
 public:
  virtual ~MeshEncoder() = default;
  virtual EncodeResult<EncodedTile> encode(const Tile& tile, const TileGrids& grids,
                                           const EncodeOptions& options) const = 0;

 protected:
  MeshEncoder() = default;
  MeshEncoder(const MeshEncoder&) = default;
  MeshEncoder& operator=(const MeshEncoder&) = default;
};

}  // namespace dini
