#include "geometry/implicit_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/chunks.h"
#include "geometry/field_blend.h"

namespace dini {

namespace {

/// A cube of cells that is looked at as a whole.
struct Block {
  std::array<std::uint32_t, 3> cell;
  SharedField field;
};

/// What is left of the field in a cube of `size` cells and one cell around; null where it cannot be zero.
SharedField field_in(const Block& block, std::uint32_t size, const ImplicitGrid& grid) {
  const auto& [i, j, k] = block.cell;
  const double half = 0.5 * size * grid.step;
  const SolidBall ball{grid.corner(i, j, k) + Vector{half, half, half}, std::sqrt(3.0) * (half + grid.step)};
  Narrowed narrowed = block.field->narrowed(ball, block.field);
  const double slack = narrowing_slack * ball.radius;
  if (narrowed.values.low > slack || narrowed.values.high < -slack) return nullptr;
  return std::move(narrowed.field);
}

/// The eight halves of a cube, as far as they have cells of the grid.
std::vector<Block> halves(const Block& block, std::uint32_t half, const ImplicitGrid& grid) {
  std::vector<Block> parts;
  for (std::uint32_t part = 0; part < 8; ++part) {
    Block child = block;
    bool within = true;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      child.cell[axis] += (part >> axis & 1) * half;
      within = within && child.cell[axis] < grid.cells[axis];
    }
    if (within) parts.push_back(std::move(child));
  }
  return parts;
}

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

std::vector<Brick> find_bricks(const SharedField& field, const ImplicitGrid& grid, const Cancel& cancel) {
  std::uint32_t size = Brick::side;
  while (size < *std::max_element(grid.cells.begin(), grid.cells.end())) size *= 2;
  std::vector<Block> blocks = {{{0, 0, 0}, field}};
  for (;; size /= 2) {
    std::vector<std::vector<Block>> found(blocks.size());
    for_chunks(cancel, blocks.size(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        blocks[b].field = field_in(blocks[b], size, grid);
        if (!blocks[b].field) continue;
        if (size == Brick::side) {
          found[b].push_back(blocks[b]);
        } else {
          found[b] = halves(blocks[b], size / 2, grid);
        }
      }
    });
    std::vector<Block> next;
    for (std::vector<Block>& part : found) std::move(part.begin(), part.end(), std::back_inserter(next));
    blocks = std::move(next);
    if (size == Brick::side || cancel.stopped()) break;
  }
  std::vector<Brick> bricks;
  bricks.reserve(blocks.size());
  for (Block& block : blocks) bricks.push_back({block.cell, std::move(block.field)});
  return bricks;
}

}  // namespace dini
