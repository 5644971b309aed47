#include "geometry/implicit_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "geometry/chunks.h"
#include "geometry/field_blend.h"

namespace dini {

namespace {

using Cell = std::array<std::uint32_t, 3>;

/// The way down the octree, many branches at once.
class Descent {
 public:
  Descent(const ImplicitGrid& grid, std::size_t most_bytes, const Cancel& cancel,
          const std::function<bool(const Brick&)>& visit)
      : grid_(grid), most_bytes_(most_bytes), cancel_(cancel), visit_(visit) {}

  /// Into a cube of `size` cells, for which the field is what is left of it in the cube around.
  void descend(const Cell& cell, std::uint32_t size, const SharedField& field) {
    if (ended_.load(std::memory_order_relaxed) || cancel_.stopped()) return;
    const double half = 0.5 * size * grid_.step;
    const SolidBall ball{grid_.corner(cell[0], cell[1], cell[2]) + Vector{half, half, half},
                         std::sqrt(3.0) * (half + grid_.step)};
    Narrowed narrowed = field->narrowed(ball, field);
    const double slack = narrowing_slack * ball.radius;
    if (narrowed.values.low > slack || narrowed.values.high < -slack) return;
    // What they share is counted as well. Both have the same values here, so a bound for memory costs time only.
    const std::size_t made = narrowed.field == field ? 0 : narrowed.field->size().bytes;
    if (made_.fetch_add(made) + made > most_bytes_) narrowed.field = field;
    if (size == Brick::side) {
      if (!visit_({cell, narrowed.field})) ended_ = true;
    } else {
      descend_halves(cell, size / 2, narrowed.field);
    }
    made_ -= made;
  }

 private:
  void descend_halves(const Cell& cell, std::uint32_t half, const SharedField& field) {
    for_chunks(cancel_, 8, 1, [&](std::size_t part, std::size_t) {
      Cell first = cell;
      bool within = true;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        first[axis] += static_cast<std::uint32_t>(part >> axis & 1) * half;
        within = within && first[axis] < grid_.cells[axis];
      }
      if (within) descend(first, half, field);
    });
  }

  const ImplicitGrid& grid_;
  const std::size_t most_bytes_;
  const Cancel& cancel_;
  const std::function<bool(const Brick&)>& visit_;
  std::atomic<std::size_t> made_ = 0;
  std::atomic<bool> ended_ = false;
};

}  // namespace

ImplicitGrid implicit_grid(const Vector& low, const Vector& high, std::size_t resolution) {
  const Vector extent = high - low;
  ImplicitGrid grid{low, std::max({extent.x, extent.y, extent.z}) / static_cast<double>(resolution), {}};
  const auto cells = [&](double length) {
    // What round-off adds to a whole number of cells is no cell.
    const double count = std::ceil(length / grid.step - 1e-6);
    return static_cast<std::uint32_t>(std::clamp(count, 1.0, static_cast<double>(resolution))) + 1;
  };
  grid.cells = {cells(extent.x), cells(extent.y), cells(extent.z)};
  return grid;
}

std::uint64_t octree_order(const Brick& brick) {
  std::uint64_t order = 0;
  for (std::uint32_t bit = 0; bit < 16; ++bit) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      order |= std::uint64_t{brick.cell[axis] / Brick::side >> bit & 1} << (3 * bit + axis);
    }
  }
  return order;
}

void visit_bricks(const SharedField& field, const ImplicitGrid& grid, std::size_t most_bytes, const Cancel& cancel,
                  const std::function<bool(const Brick&)>& visit) {
  std::uint32_t size = Brick::side;
  while (size < *std::max_element(grid.cells.begin(), grid.cells.end())) size *= 2;
  Descent(grid, most_bytes, cancel, visit).descend({0, 0, 0}, size, field);
}

}  // namespace dini
