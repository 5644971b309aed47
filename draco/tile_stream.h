#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "draco/tile_topology.h"

namespace dini {

/// Where the numbers of an attribute lie: at `origin` plus whole steps, 2^bits - 1 of them to `range`.
struct StreamGrid {
  std::array<float, 3> origin = {};
  float range = 1;
  int bits = 14;  ///< 1 to 20
};

/// The attributes of a tile, one for each of its vertices; all but the positions may be empty. Positions and texture
/// coordinates are finite and on their grids, normals are not zero.
struct StreamAttributes {
  std::span<const std::array<float, 3>> positions;
  std::span<const std::array<float, 3>> normals;
  std::span<const std::array<float, 2>> uvs;
  std::span<const std::array<std::uint16_t, 4>> colors;
  StreamGrid position_grid;
  StreamGrid uv_grid;
  int normal_bits = 10;  ///< 2 to 16
};

/// A Draco stream (bitstream 2.2) of a manifold tile: edgebreaker, attributes predicted by parallelograms, normals by
/// the one before. Attributes are numbered from 0 in the order above, without those that are empty. `effort` is that of
/// the tables (draco/symbol_coding.h). The bytes are those that libdraco writes for the same tile at speed 10 - effort.
std::vector<char> tile_stream(const TileTopology& topology, const StreamAttributes& attributes, int effort);

}  // namespace dini
