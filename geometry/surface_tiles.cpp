#include "geometry/surface_tiles.h"

#include <algorithm>
#include <atomic>

#include "geometry/chunks.h"
#include "geometry/tiles.h"

namespace dini {

namespace {

/// Rows of quads that are looked at at once, so that a single tile has work for several threads.
constexpr std::size_t rows_at_once = 32;

kernels::ConstPoints components(const Column<Vector>& vectors) {
  return {vectors.component(0), vectors.component(1), vectors.component(2)};
}

grid_lanes::QuadFacts facts_of_rows(const GridSamples& samples, kernels::ConstPoints normals, const QuadBlock& block,
                                    std::uint8_t* doubtful) {
  const grid_lanes::QuadLimits limits = {samples.tolerance(), samples.longest_step()};
  // The quads behind the last column join it with the first.
  const std::size_t last = samples.columns().size() - 1;
  const std::size_t straight_end = std::min(block.column_end, last);
  grid_lanes::QuadFacts facts;
  const auto look = [&](std::size_t row, std::size_t from, std::size_t to, std::size_t count) {
    const std::size_t next = samples.rows().next(row);
    facts |= grid_lanes::facts_of(
        samples.positions(), normals,
        {samples.index(row, from), samples.index(next, from), samples.index(next, to), samples.index(row, to), count},
        limits, doubtful);
  };
  for (std::size_t row = block.row_begin; row < block.row_end; ++row) {
    if (block.column_begin < straight_end) {
      look(row, block.column_begin, block.column_begin + 1, straight_end - block.column_begin);
    }
    if (straight_end < block.column_end) look(row, last, 0, 1);
  }
  return facts;
}

bool any_torn(const GridSamples& samples, const QuadBlock& block) {
  if (!samples.torn()) return false;
  for (std::size_t row = block.row_begin; row < block.row_end; ++row) {
    for (std::size_t column = block.column_begin; column < block.column_end; ++column) {
      if (samples.torn(samples.index(row, column))) return true;
    }
  }
  return false;
}

void doubt_backs(const GridSamples& samples, const IrregularTile& tile, const Column<Vector>& normals,
                 Zeroed<std::uint8_t>& doubtful) {
  for (const auto& [begin, end] : tile.runs) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& triangle = tile.triangles[i];
      const Vector a = corner_position(samples, tile, triangle[0]), b = corner_position(samples, tile, triangle[1]);
      const Vector c = corner_position(samples, tile, triangle[2]);
      const Vector area = cross(b - a, c - a);
      for (const std::uint32_t corner : triangle) {
        if (corner >= samples.size() || dot(normals[corner], area) > 0) continue;
        std::atomic_ref(doubtful[corner]).store(1, std::memory_order_relaxed);
      }
    }
  }
}

}  // namespace

std::vector<TileFacts> tile_facts(const GridSamples& samples, const Column<Vector>& normals,
                                  Zeroed<std::uint8_t>& doubtful, const Cancel& cancel) {
  std::vector<TileFacts> tiles;
  for_each_tile(samples.rows().steps(), samples.columns().steps(),
                [&](std::size_t row_begin, std::size_t row_end, std::size_t column_begin, std::size_t column_end) {
                  tiles.push_back({{row_begin, row_end, column_begin, column_end}, {}, {}});
                  return true;
                });
  struct Piece {
    std::size_t tile;
    QuadBlock block;
    grid_lanes::QuadFacts facts;
  };
  std::vector<Piece> pieces;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    QuadBlock block = tiles[tile].block;
    for (std::size_t row = block.row_begin; row < tiles[tile].block.row_end; row += rows_at_once) {
      block.row_begin = row;
      block.row_end = std::min(row + rows_at_once, tiles[tile].block.row_end);
      pieces.push_back({tile, block, {}});
    }
  }
  for_chunks(cancel, pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Piece& piece = pieces[i];
      piece.facts = samples.inside(piece.block)
                        ? facts_of_rows(samples, components(normals), piece.block, doubtful.data())
                        : grid_lanes::QuadFacts{true, true, true};
    }
  });
  for (const Piece& piece : pieces) {
    tiles[piece.tile].facts |= piece.facts;
    tiles[piece.tile].pieces.push_back({piece.block, piece.facts});
  }
  return tiles;
}

std::vector<SurfaceTile> surface_tiles(const GridSamples& samples, const std::vector<TileFacts>& facts,
                                       const Column<Vector>& normals, Zeroed<std::uint8_t>& doubtful,
                                       const Cancel& cancel) {
  std::vector<SurfaceTile> tiles(facts.size());
  for_chunks(cancel, tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      tiles[i].block = facts[i].block;
      if (!facts[i].facts.irregular && !any_torn(samples, facts[i].block)) continue;
      std::vector<TilePiece> pieces;
      for (const auto& [block, known] : facts[i].pieces) {
        pieces.push_back({block, !known.irregular && !any_torn(samples, block)});
      }
      tiles[i].irregular = irregular_tile(samples, pieces, cancel);
      doubt_backs(samples, *tiles[i].irregular, normals, doubtful);
    }
  });
  return tiles;
}

}  // namespace dini
