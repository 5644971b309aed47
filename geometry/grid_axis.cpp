#include "geometry/grid_axis.h"

#include <algorithm>
#include <cmath>

namespace dini {

namespace {

/// How many steps an axis has and how few it may be thinned to.
struct Steps {
  std::size_t all = 0, least = 0;

  Steps(std::size_t size, bool closed)
      : all(closed ? size : size - 1),
        least(std::min<std::size_t>(all, closed ? 3 : 2)) {}  // between two poles there is a row
  std::size_t clamped(std::size_t wanted) const { return std::clamp(wanted, least, all); }
};

GridAxis thinned(std::size_t size, bool closed, std::size_t steps) {
  GridAxis axis{{}, size, closed};
  const std::size_t count = closed || steps == 0 ? std::max<std::size_t>(steps, 1) : steps + 1;
  const std::size_t whole = closed ? size : size - 1;
  axis.kept.reserve(count);
  for (std::size_t i = 0; i < count; ++i) axis.kept.push_back(steps == 0 ? 0 : i * whole / steps);
  return axis;
}

}  // namespace

std::pair<GridAxis, GridAxis> grid_axes(std::size_t rows, bool closed_rows, std::size_t columns, bool closed_columns,
                                        std::size_t triangle_budget) {
  if (rows == 0 || columns == 0) return {};
  closed_rows = closed_rows && rows >= 3;
  closed_columns = closed_columns && columns >= 3;
  const Steps along_rows(rows, closed_rows);
  const Steps along_columns(columns, closed_columns);
  std::size_t row_steps = along_rows.all;
  std::size_t column_steps = along_columns.all;
  const std::size_t quads = triangle_budget / 2;
  if (triangle_budget > 0 && row_steps > 0 && column_steps > quads / row_steps) {
    const double shrink =
        std::sqrt(static_cast<double>(quads) / (static_cast<double>(row_steps) * static_cast<double>(column_steps)));
    row_steps = along_rows.clamped(static_cast<std::size_t>(static_cast<double>(row_steps) * shrink));
    column_steps = along_columns.clamped(quads / row_steps);
    row_steps = along_rows.clamped(quads / column_steps);
  }
  return {thinned(rows, closed_rows, row_steps), thinned(columns, closed_columns, column_steps)};
}

}  // namespace dini
