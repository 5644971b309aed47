#include "geometry/grid_samples.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <tuple>

#include "geometry/chunks.h"
#include "geometry/clip.h"
#include "geometry/extremes.h"
#include "geometry/grid_lanes.h"
#include "geometry/grid_tear.h"

namespace dini {

namespace {

kernels::ConstPoints components(const Column<Point>& points, std::size_t begin) {
  return {points.component(0) + begin, points.component(1) + begin, points.component(2) + begin};
}

}  // namespace

GridSamples::GridSamples(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel)
    : clip_radius_(std::min(options.clip_radius, largest_clip_radius)) {
  std::tie(rows_, columns_) =
      grid_axes(grid.rows, grid.closed_rows, grid.columns, grid.closed_columns, options.triangle_budget);
  read(grid, cancel);
  place_samples(cancel);
  tolerance_ = relative_round_off * largest_;
}

void GridSamples::read(const PointGrid& grid, const Cancel& cancel) {
  const bool as_they_lie = rows_.size() == grid.rows && columns_.size() == grid.columns && grid.column_stride == 1 &&
                           grid.row_stride == grid.columns;
  if (as_they_lie && size() > 0) {
    positions_ = components(grid.points, grid.offset);
    return;
  }
  copy_ = Column<Point>(size());
  const std::size_t rows_at_once = std::max<std::size_t>(1, usual_chunk / std::max<std::size_t>(1, columns_.size()));
  for_chunks(cancel, rows_.size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = 0; k < Column<Point>::width; ++k) {
      const double* const from = grid.points.component(k) + grid.offset;
      double* to = copy_.component(k) + index(begin, 0);
      for (std::size_t row = begin; row < end; ++row) {
        const double* const line = from + rows_.kept[row] * grid.row_stride;
        for (const std::size_t column : columns_.kept) *to++ = line[column * grid.column_stride];
      }
    }
  });
  positions_ = components(copy_, 0);
}

void GridSamples::place_samples(const Cancel& cancel) {
  const double limit = clip_radius_ > 0 ? clip_radius_ * clip_radius_ : -1;
  const auto from = [&](std::size_t begin) -> kernels::ConstPoints {
    return {positions_.x + begin, positions_.y + begin, positions_.z + begin};
  };
  std::atomic<double> largest = 0;
  std::atomic<bool> all_inside = true;
  for_chunks(cancel, size(), [&](std::size_t begin, std::size_t end) {
    const grid_lanes::Extent extent = grid_lanes::extent_of(from(begin), end - begin, limit);
    if (extent.inside) {
      raise_to(largest, extent.largest);
    } else {
      all_inside = false;
    }
  });
  if (all_inside) {
    largest_ = largest;
    return;
  }
  places_ = Zeroed<Place>(size());
  for_chunks(cancel, size(), [&](std::size_t begin, std::size_t end) {
    double most = 0;
    for (std::size_t sample = begin; sample < end; ++sample) {
      const Vector at = position(sample);
      if (!is_finite(at)) continue;
      places_[sample] = squared_length(at) <= limit ? Place::inside : Place::outside;
      if (places_[sample] == Place::inside) most = std::max(most, largest_component(at));
    }
    raise_to(largest, most);
  });
  largest_ = largest;
}

bool GridSamples::inside(const QuadBlock& block) const {
  if (places_.empty()) return true;
  for (std::size_t row = block.row_begin; row <= block.row_end; ++row) {
    for (std::size_t column = block.column_begin; column <= block.column_end; ++column) {
      if (places_[index(row % rows_.size(), column % columns_.size())] != Place::inside) return false;
    }
  }
  return true;
}

std::optional<std::array<std::size_t, 2>> GridSamples::first_clipped() const {
  for (std::size_t sample = 0; sample < size() && !whole(); ++sample) {
    if (place(sample) == Place::inside && !torn(sample)) continue;
    return {{rows_.kept[row_of(sample)], columns_.kept[column_of(sample)]}};
  }
  return std::nullopt;
}

double GridSamples::longest_step() const { return ordinary_step * clip_radius_; }

bool GridSamples::has_short_sides(std::size_t row, std::size_t column) const {
  const Vector a = position(index(row, column)), b = position(index(rows_.next(row), column));
  const Vector c = position(index(rows_.next(row), columns_.next(column)));
  const Vector d = position(index(row, columns_.next(column)));
  const double limit = longest_step() * longest_step() * (1 - 1e-9);
  // Sides that are not finite are not short.
  return squared_length(b - a) <= limit && squared_length(c - b) <= limit && squared_length(d - c) <= limit &&
         squared_length(a - d) <= limit;
}

int GridSamples::tears_of(std::size_t row, std::size_t column) const {
  const double least_step = longest_step();
  if (has_short_sides(row, column)) return 0;
  const auto shape = [&](std::size_t at_row, std::size_t at_column, bool rows) -> QuadShape {
    const std::size_t a = index(at_row, at_column);
    const std::size_t b = index(rows_.next(at_row), at_column);
    const std::size_t c = index(rows_.next(at_row), columns_.next(at_column));
    const std::size_t d = index(at_row, columns_.next(at_column));
    for (const std::size_t corner : {a, b, c, d}) {
      if (place(corner) == Place::infinite) return {};
    }
    // Far corners are drawn in, so that nothing overflows.
    const double scale = 1 / std::max({1.0, largest_component(position(a)), largest_component(position(b)),
                                       largest_component(position(c)), largest_component(position(d))});
    const Vector ac = scale * position(c) - scale * position(a);
    const Vector bd = scale * position(d) - scale * position(b);
    const Vector step = rows ? 0.5 * (ac - bd) : 0.5 * (ac + bd);
    return {cross(ac, bd), step / scale, true};
  };
  const auto test = [&](bool along) {
    const QuadShape quad = shape(row, column, along);
    if (!quad.known || length(quad.step) <= least_step) return false;
    const GridAxis& axis = along ? rows_ : columns_;
    const std::size_t at = along ? row : column;
    const auto neighbor = [&](std::size_t to) { return along ? shape(to, column, true) : shape(row, to, false); };
    const QuadShape before = axis.closed || at > 0 ? neighbor(axis.previous(at)) : QuadShape{};
    const QuadShape after = axis.closed || at + 1 < axis.steps() ? neighbor(axis.next(at)) : QuadShape{};
    return holds_infinity(before, quad, after, least_step);
  };
  return (test(true) ? along_rows : 0) + (test(false) ? along_columns : 0);
}

void GridSamples::tear(const std::vector<QuadBlock>& blocks, const Cancel& cancel) {
  if (blocks.empty()) return;
  std::atomic<bool> any = false;
  Zeroed<std::uint8_t> found(size());
  for_chunks(cancel, blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
    CancelEvery steps(cancel);
    for (std::size_t i = begin; i < end; ++i) {
      const QuadBlock& block = blocks[i];
      for (std::size_t row = block.row_begin; row < block.row_end; ++row) {
        for (std::size_t column = block.column_begin; column < block.column_end && !steps.stopped(); ++column) {
          const int bits = tears_of(row, column);
          if (bits == 0) continue;
          found[index(row, column)] = static_cast<std::uint8_t>(bits);
          any = true;
        }
      }
    }
  });
  if (any) torn_ = std::move(found);
}

void GridSamples::unite(std::size_t a, std::size_t b) {
  if (place(a) != Place::inside || place(b) != Place::inside) return;
  const Vector apart = position(a) - position(b);
  if (largest_component(apart) > tolerance_) return;
  const auto root = [&](std::size_t sample) {
    while (labels_[sample] != sample) sample = labels_[sample] = labels_[labels_[sample]];
    return sample;
  };
  a = root(a);
  b = root(b);
  labels_[std::max(a, b)] = static_cast<std::uint32_t>(std::min(a, b));
}

void GridSamples::weld(const std::vector<QuadBlock>& blocks, const Cancel& cancel) {
  if (blocks.empty()) return;
  labels_ = Zeroed<std::uint32_t>(size());
  std::iota(labels_.data(), labels_.data() + labels_.size(), 0u);
  CancelEvery steps(cancel);
  for (const QuadBlock& block : blocks) {
    for (std::size_t row = block.row_begin; row < block.row_end; ++row) {
      for (std::size_t column = block.column_begin; column < block.column_end && !steps.stopped(); ++column) {
        const std::size_t a = index(row, column), b = index(rows_.next(row), column);
        const std::size_t d = index(row, columns_.next(column)), c = index(rows_.next(row), columns_.next(column));
        unite(a, b);
        unite(a, d);
        // The sides that no further quad of the block has.
        if (row + 1 == block.row_end) unite(b, c);
        if (column + 1 == block.column_end) unite(d, c);
      }
    }
  }
  merged_ = Zeroed<std::uint8_t>(size());
  for (std::size_t sample = 0; sample < labels_.size() && !steps.stopped(); ++sample) {
    // Labels point at smaller samples, whose own labels are final already.
    labels_[sample] = labels_[labels_[sample]];
    if (labels_[sample] != sample) merged_[labels_[sample]] = 1;
  }
}

}  // namespace dini
