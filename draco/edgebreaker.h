#pragma once

// Edgebreaker: a mesh as the walk of a spiral over its triangles, one symbol a triangle (Rossignac 1999; Isenburg and
// Snoeyink, "Spirale Reversi", 2000; Draco bitstream 2.2).

#include <cstdint>
#include <vector>

#include "draco/corner_table.h"

namespace dini {

/// What a triangle is to the walk, by what lies beyond its two free edges.
enum class Symbol : std::uint8_t {
  c,  ///< its tip is new, and no boundary: the walk goes right
  s,  ///< both sides are free: the walk goes right, and left later
  l,  ///< the left is done: the walk goes right
  r,  ///< the right is done: the walk goes left
  e,  ///< both are done: this branch ends
};

/// A branch that runs into a triangle where another one split, around a handle of the mesh.
struct SplitEvent {
  std::uint32_t source = 0;  ///< symbol of the branch that ends there
  std::uint32_t split = 0;   ///< symbol of the triangle with two free sides
  bool right = false;        ///< which edge of the source is joined
};

/// The walk over all triangles. Decoders rebuild the triangles in the opposite order of `corners`, then add `closing`.
struct Edgebreaker {
  std::vector<Symbol> symbols;
  std::vector<Corner> corners;      ///< the tip of each symbol's triangle
  std::vector<bool> closed;         ///< for each connected piece, whether it began with a triangle without a symbol
  std::vector<Corner> closing;      ///< the tip of that triangle, toward the walk, for each closed piece
  std::vector<SplitEvent> splits;   ///< in the order of their sources
  std::uint32_t split_symbols = 0;  ///< how many symbols are `s`
};

Edgebreaker edgebreaker(const CornerTable& table);

}  // namespace dini
