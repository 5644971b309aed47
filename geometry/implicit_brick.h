#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/implicit_cell.h"
#include "geometry/implicit_grid.h"

namespace dini {

/// A cell through which the surface passes.
struct CrossedCell {
  std::array<std::uint8_t, 3> place;  ///< in its brick
  std::uint8_t inside = 0;            ///< bit of each corner that is inside
  bool sharp = false;                 ///< has a vertex on an edge of the surface
  CellLoops loops;
  std::uint32_t first = 0;                ///< its first vertex in the brick
  std::array<std::uint8_t, 12> vertices;  ///< at which place from there on the vertex of each crossed edge is
};

/// The cells of a brick that the surface passes through, and their vertices.
struct BrickSurface {
  static constexpr std::uint16_t none = 0xFFFF;
  static constexpr std::size_t cells = std::size_t{Brick::side} * Brick::side * Brick::side;

  std::vector<Vector> places, normals;
  std::vector<CrossedCell> crossed;
  std::vector<std::uint16_t> cell_at;  ///< by place in the brick, first axis fastest; empty where no cell is crossed

  const CrossedCell* cell(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    if (cell_at.empty()) return nullptr;
    const std::uint16_t index = cell_at[i + Brick::side * (j + Brick::side * k)];
    return index == none ? nullptr : &crossed[index];
  }
};

/// The part of the surface in a brick. Looks at the flag often enough for a field that takes long. Stopped early:
/// nothing.
BrickSurface surface_in(const Brick& brick, const ImplicitGrid& grid, const Cancel& cancel);

/// Where the field is zero between two places at which its values have different signs.
Vector crossing_between(const ScalarField& field, const Vector& from, const Vector& to);

/// The direction in which the field grows, of length one; `otherwise` where it has none.
Vector normal_at(const ScalarField& field, const Vector& place, const Vector& otherwise);

}  // namespace dini
