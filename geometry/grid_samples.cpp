#include "geometry/grid_samples.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/clip.h"
#include "geometry/grid_tear.h"

namespace dini {

GridSamples::GridSamples(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel)
    : clip_radius_(std::min(options.clip_radius, largest_clip_radius)) {
  std::tie(rows_, columns_) =
      grid_axes(grid.rows, grid.closed_rows, grid.columns, grid.closed_columns, options.triangle_budget);
  read(grid, cancel);
  tear(cancel);
  weld(cancel);
}

void GridSamples::note_clipped(std::size_t sample) {
  const std::array<std::size_t, 2> at = {rows_.kept[row_of(sample)], columns_.kept[column_of(sample)]};
  if (!first_clipped_ || at < *first_clipped_) first_clipped_ = at;
}

void GridSamples::read(const PointGrid& grid, const Cancel& cancel) {
  const std::size_t count = rows_.size() * columns_.size();
  positions_ = Zeroed<Vector>(count);
  places_ = Zeroed<Place>(count);
  CancelEvery steps(cancel);
  const double limit = clip_radius_ > 0 ? clip_radius_ * clip_radius_ : -1;
  double largest = 0;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (std::size_t column = 0; column < columns_.size() && !steps.stopped(); ++column) {
      const std::size_t from =
          grid.offset + rows_.kept[row] * grid.row_stride + columns_.kept[column] * grid.column_stride;
      const std::size_t sample = index(row, column);
      const Vector position = to_vector(grid.points[from]);
      positions_[sample] = position;
      if (is_finite(position)) {
        places_[sample] = squared_length(position) <= limit ? Place::inside : Place::outside;
      }
      if (places_[sample] == Place::inside) {
        largest = std::max(largest, largest_component(position));
      } else {
        note_clipped(sample);
      }
    }
  }
  largest_ = largest;
  tolerance_ = relative_round_off * largest;
}

void GridSamples::tear(const Cancel& cancel) {
  const double least_step = ordinary_step * clip_radius_;
  // Two points of a box around the origin are at most this far apart.
  if (whole() && 2 * std::sqrt(3.0) * largest_ < least_step) return;
  const auto shape = [&](std::size_t row, std::size_t column, bool rows) -> QuadShape {
    const std::size_t a = index(row, column);
    const std::size_t b = index(rows_.next(row), column);
    const std::size_t c = index(rows_.next(row), columns_.next(column));
    const std::size_t d = index(row, columns_.next(column));
    for (const std::size_t corner : {a, b, c, d}) {
      if (places_[corner] == Place::infinite) return {};
    }
    // Far corners are drawn in, so that nothing overflows.
    const double scale = 1 / std::max({1.0, largest_component(positions_[a]), largest_component(positions_[b]),
                                       largest_component(positions_[c]), largest_component(positions_[d])});
    const Vector ac = scale * positions_[c] - scale * positions_[a];
    const Vector bd = scale * positions_[d] - scale * positions_[b];
    const Vector step = rows ? 0.5 * (ac - bd) : 0.5 * (ac + bd);
    return {cross(ac, bd), step / scale, true};
  };
  const auto test = [&](std::size_t row, std::size_t column, bool along) {
    const QuadShape quad = shape(row, column, along);
    if (!quad.known || length(quad.step) <= least_step) return false;
    const GridAxis& axis = along ? rows_ : columns_;
    const std::size_t at = along ? row : column;
    const auto neighbor = [&](std::size_t to) { return along ? shape(to, column, true) : shape(row, to, false); };
    const QuadShape before = axis.closed || at > 0 ? neighbor(axis.previous(at)) : QuadShape{};
    const QuadShape after = axis.closed || at + 1 < axis.steps() ? neighbor(axis.next(at)) : QuadShape{};
    return holds_infinity(before, quad, after, least_step);
  };
  CancelEvery steps(cancel);
  for (std::size_t row = 0; row < rows_.steps(); ++row) {
    for (std::size_t column = 0; column < columns_.steps() && !steps.stopped(); ++column) {
      const int bits = (test(row, column, true) ? along_rows : 0) + (test(row, column, false) ? along_columns : 0);
      if (bits == 0) continue;
      if (torn_.empty()) torn_ = Zeroed<std::uint8_t>(positions_.size());
      torn_[index(row, column)] = static_cast<std::uint8_t>(bits);
      note_clipped(index(row, column));
    }
  }
}

void GridSamples::unite(std::size_t a, std::size_t b) {
  if (places_[a] != Place::inside || places_[b] != Place::inside) return;
  const Vector apart = positions_[a] - positions_[b];
  if (largest_component(apart) > tolerance_) return;
  const auto root = [&](std::size_t sample) {
    while (labels_[sample] != sample) sample = labels_[sample] = labels_[labels_[sample]];
    return sample;
  };
  a = root(a);
  b = root(b);
  labels_[std::max(a, b)] = static_cast<std::uint32_t>(std::min(a, b));
}

void GridSamples::weld(const Cancel& cancel) {
  labels_ = Zeroed<std::uint32_t>(positions_.size());
  std::iota(labels_.data(), labels_.data() + labels_.size(), 0u);
  CancelEvery steps(cancel);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (std::size_t column = 0; column < columns_.size() && !steps.stopped(); ++column) {
      if (row < rows_.steps()) unite(index(row, column), index(rows_.next(row), column));
      if (column < columns_.steps()) unite(index(row, column), index(row, columns_.next(column)));
    }
  }
  merged_.resize(positions_.size());
  for (std::size_t sample = 0; sample < labels_.size() && !steps.stopped(); ++sample) {
    // Labels point at smaller samples, whose own labels are final already.
    labels_[sample] = labels_[labels_[sample]];
    if (labels_[sample] != sample) merged_[labels_[sample]] = true;
  }
}

}  // namespace dini
