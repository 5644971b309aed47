#pragma once

// A grid in tiles: of which the triangles are plain, and which have to be looked at quad by quad.

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/grid_lanes.h"
#include "geometry/grid_samples.h"
#include "geometry/irregular_tile.h"

namespace dini {

/// A tile of a surface. Without `irregular` each of its quads a b c d is the triangles a b c and a c d.
struct SurfaceTile {
  QuadBlock block;
  std::optional<IrregularTile> irregular;

  std::size_t quads() const { return (block.row_end - block.row_begin) * (block.column_end - block.column_begin); }
  std::size_t triangles() const { return irregular ? irregular->triangles.size() : 2 * quads(); }
};

/// A tile and what its quads are like, all of them and those of a few rows each.
struct TileFacts {
  QuadBlock block;
  grid_lanes::QuadFacts facts;
  std::vector<std::pair<QuadBlock, grid_lanes::QuadFacts>> pieces;
};

/// Looks at all quads of a grid, tile by tile. Samples whose normal does not look to the front of each triangle around
/// them become 1 in `doubtful`; only where tiles are regular are all found. Stopped early: facts that mean nothing.
std::vector<TileFacts> tile_facts(const GridSamples& samples, const Column<Vector>& normals,
                                  Zeroed<std::uint8_t>& doubtful, const Cancel& cancel);

/// The tiles of a grid of which all is known, with the triangles of the irregular ones. Their samples whose normal does
/// not look to the front of each triangle become 1 in `doubtful`.
std::vector<SurfaceTile> surface_tiles(const GridSamples& samples, const std::vector<TileFacts>& facts,
                                       const Column<Vector>& normals, Zeroed<std::uint8_t>& doubtful,
                                       const Cancel& cancel);

}  // namespace dini
