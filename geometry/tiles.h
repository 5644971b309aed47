#pragma once

#include <algorithm>
#include <cstddef>

namespace dini {

/// The longest side of a tile, in quads. Compact tiles keep references local, which encodes better and faster.
inline constexpr std::size_t tile_side = 128;

/// Calls body(row_begin, row_end, column_begin, column_end) for every block of at most tile_side x tile_side quads of a
/// rows x columns array of quads, row by row. Stops when `body` returns false.
template <class Body>
void for_each_tile(std::size_t rows, std::size_t columns, Body body) {
  for (std::size_t row = 0; row < rows; row += tile_side) {
    for (std::size_t column = 0; column < columns; column += tile_side) {
      if (!body(row, std::min(row + tile_side, rows), column, std::min(column + tile_side, columns))) return;
    }
  }
}

}  // namespace dini
