#pragma once

// One axis of a grid that becomes a surface, perhaps thinned out.

#include <cstddef>
#include <utility>
#include <vector>

namespace dini {

/// The samples of an axis that are kept: ascending indices into the `full_size` samples it was given with.
struct GridAxis {
  std::vector<std::size_t> kept;
  std::size_t full_size = 0;
  bool closed = false;

  std::size_t size() const { return kept.size(); }

  /// Number of steps from a sample to the next one.
  std::size_t steps() const { return kept.empty() ? 0 : closed ? kept.size() : kept.size() - 1; }

  std::size_t next(std::size_t index) const { return index + 1 < kept.size() ? index + 1 : 0; }
  std::size_t previous(std::size_t index) const { return index > 0 ? index - 1 : kept.size() - 1; }

  /// Distance to the next kept sample, in samples of the full axis.
  double step_length(std::size_t index) const {
    const std::size_t to = index + 1 < kept.size() ? kept[index + 1] : full_size + kept[0];
    return static_cast<double>(to - kept[index]);
  }

  /// Texture coordinate of a kept sample.
  double coordinate(std::size_t index) const {
    const std::size_t whole = closed ? full_size : full_size - 1;
    return whole == 0 ? 0 : static_cast<double>(kept[index]) / static_cast<double>(whole);
  }
};

/// The two axes of a grid, thinned out evenly and near the same proportion until two triangles per quad are within
/// `triangle_budget` (0: no limit); open axes keep both ends and a sample between them, closed ones three samples.
/// Closed axes of fewer than three samples become open.
std::pair<GridAxis, GridAxis> grid_axes(std::size_t rows, bool closed_rows, std::size_t columns, bool closed_columns,
                                        std::size_t triangle_budget);

}  // namespace dini
