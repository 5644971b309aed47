#pragma once

// How a surface passes through one cell, from the signs and values at its corners (Nielson, Dual Marching Cubes, 2004).
// Corner c has coordinates c & 1, c >> 1 & 1, c >> 2 & 1. Edge 4 a + p + 2 q runs along axis a, at p along axis a + 1
// and q along axis a + 2. Face 2 a + s is across axis a, at s along it.

#include <array>
#include <cstdint>

namespace dini {

inline constexpr std::uint8_t no_loop = 15;

/// The corners at the ends of an edge, the lower one first.
std::array<int, 2> ends_of_edge(int edge);

/// The four edges around a face, which two faces that lie on one another give in the same order.
const std::array<int, 4>& edges_of_face(int face);

/// The loops of edges at which pieces of surface leave a cell: each piece is a disk and becomes one vertex. Where all
/// four edges of a face are crossed, the value at the saddle between its corners decides which two belong together, so
/// both cells at the face say the same.
struct CellLoops {
  std::array<std::uint8_t, 12> loop;  ///< of each edge; `no_loop` where the surface does not cross it
  std::uint8_t count = 0;
  std::uint8_t doubled = 0;  ///< bit of each face through which one loop passes twice
  std::uint8_t paired = 0;   ///< bit of each face where edges 1 and 2 belong together, not 0 and 1

  bool is_doubled(int face) const { return (doubled >> face & 1) != 0; }
  /// Which of the two curves on a face with four crossed edges an edge is an end of.
  int curve_on(int face, int edge) const;
};

/// The loops of a cell with these values at its corners; below zero is inside.
CellLoops loops_of(const std::array<double, 8>& values);

}  // namespace dini
