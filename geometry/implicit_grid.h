#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "geometry/cancel.h"
#include "geometry/scalar_field.h"

namespace dini {

/// Cubic cells that cover a box and half a cell more on all sides, so that the border of the box runs through the
/// middle of the outermost ones.
struct ImplicitGrid {
  Vector low;
  double step = 1;
  std::array<std::uint32_t, 3> cells = {0, 0, 0};

  /// The lower corner of a cell. One place has the same coordinates to the last bit in whichever cell it is met.
  Vector corner(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const auto at = [&](double start, std::uint32_t index) {
      return start + step * (static_cast<double>(index) - 0.5);
    };
    return {at(low.x, i), at(low.y, j), at(low.z, k)};
  }
};

/// The grid with `resolution` cells along the longest side of a box.
ImplicitGrid implicit_grid(const Vector& low, const Vector& high, std::size_t resolution);

/// A cube of cells in which a field may be zero, and what is left of the field there and one cell around.
struct Brick {
  static constexpr std::uint32_t side = 8;

  std::array<std::uint32_t, 3> cell;  ///< its first
  SharedField field;
};

/// Where a brick stands among all others in the order of an octree.
std::uint64_t octree_order(const Brick& brick);

/// Calls `visit` with each brick where the bounds of the field allow zero, on all threads and in any order, until one
/// call answers false. What is left of the field is made on the way down an octree and let go of on the way up: at any
/// time there is about `most_bytes` of it, whatever the field is. Stopped early: some bricks are left out.
void visit_bricks(const SharedField& field, const ImplicitGrid& grid, std::size_t most_bytes, const Cancel& cancel,
                  const std::function<bool(const Brick&)>& visit);

}  // namespace dini
