#include "gltf/tile_encoder.h"

#include "draco/tile_stream.h"

namespace dini {
namespace {

constexpr int slowest_speed = 7;
constexpr int fastest_speed = 9;  // 10 stores the triangle list

StreamGrid stream_grid(const QuantizationGrid& grid) { return {grid.box().minimum, grid.range(), grid.bits()}; }

EncodedTile described(const Tile& tile, std::vector<char> bytes) {
  EncodedTile result;
  result.bytes = std::move(bytes);
  result.vertices = tile.positions.size();
  result.triangles = tile.triangles.size();
  int id = 0;
  result.position_id = id++;
  if (!tile.normals.empty()) result.normal_id = id++;
  if (!tile.uvs.empty()) result.uv_id = id++;
  if (!tile.colors.empty()) result.color_id = id++;
  return result;
}

}  // namespace

EncodeResult<EncodedTile> TileEncoder::encode(const Tile& tile, const TileGrids& grids,
                                              const EncodeOptions& options) const {
  if (options.speed < slowest_speed || options.speed > fastest_speed || tile.triangles.empty()) {
    return libdraco_.encode(tile, grids, options);
  }
  const auto topology = options.topologies != nullptr
                            ? options.topologies->topology(tile.triangles, tile.positions.size())
                            : tile_topology(tile.triangles, tile.positions.size());
  if (topology == nullptr) return libdraco_.encode(tile, grids, options);
  const StreamAttributes attributes = {
      tile.positions,         tile.normals,       tile.uvs, tile.colors, stream_grid(grids.positions),
      stream_grid(grids.uvs), options.normal_bits};
  return described(tile, tile_stream(*topology, attributes, 10 - options.speed));
}

}  // namespace dini
