#pragma once

// The general way to the triangles of a part of a grid: quad by quad, with cuts at the clip sphere, neighbors that
// coincide, and triangles without area.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/grid_samples.h"

namespace dini {

/// A vertex on the way between a sample inside the clip sphere and one outside.
struct CutVertex {
  std::size_t from = 0, to = 0;
  double way = 0;  ///< 0 at `from`, 1 at `to`
  Vector position;
  std::array<double, 2> uv = {};
};

/// Rows of quads of a tile. In plain ones no quad is torn or cut, and each may be split into a b c and a c d, unless
/// corners coincide with samples beyond it.
struct TilePiece {
  QuadBlock block;
  bool plain = false;
};

/// The triangles of a tile. Their corners are labels of samples or, from the number of samples on, indices of `cuts`.
struct IrregularTile {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::size_t, 2>> runs;  ///< begins and ends of the triangles of pieces that are not plain
  std::vector<CutVertex> cuts;
  std::size_t clipped_quads = 0;
};

IrregularTile irregular_tile(const GridSamples& samples, const std::vector<TilePiece>& pieces, const Cancel& cancel);

/// The position of a corner of a tile.
inline Vector corner_position(const GridSamples& samples, const IrregularTile& tile, std::uint32_t corner) {
  return corner < samples.size() ? samples.position(corner) : tile.cuts[corner - samples.size()].position;
}

/// Texture coordinates of a sample.
std::array<double, 2> coordinates_of(const GridSamples& samples, std::size_t sample);

}  // namespace dini
