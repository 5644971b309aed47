#pragma once

// The samples of a grid that becomes a surface: where they are, which of them are at infinity, where the surface was
// torn by running through infinity between samples, and which neighbors coincide.

#include <cstdint>
#include <optional>
#include <vector>

#include "algebra/kernels.h"
#include "geometry/grid_axis.h"
#include "geometry/surface.h"
#include "geometry/zeroed.h"

namespace dini {

/// Where a sample lies: within the clip radius, finite but beyond it, or not finite.
enum class Place : std::uint8_t { infinite, outside, inside };

/// A block of quads.
struct QuadBlock {
  std::size_t row_begin = 0, row_end = 0, column_begin = 0, column_end = 0;
};

/// A thinned grid, read once. Sample (row, column) has the index row * columns.size() + column; quad (row, column) lies
/// between that sample and the next ones along both axes and has the same index. Points that lie in this order already
/// are not copied, so the grid must outlive its samples. Stopped early: what it tells means nothing.
class GridSamples {
 public:
  GridSamples(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel);

  const GridAxis& rows() const { return rows_; }
  const GridAxis& columns() const { return columns_; }
  std::size_t size() const { return rows_.size() * columns_.size(); }
  std::size_t index(std::size_t row, std::size_t column) const { return row * columns_.size() + column; }
  std::size_t row_of(std::size_t sample) const { return sample / columns_.size(); }
  std::size_t column_of(std::size_t sample) const { return sample % columns_.size(); }

  Vector position(std::size_t sample) const {
    return {positions_.x[sample], positions_.y[sample], positions_.z[sample]};
  }
  kernels::ConstPoints positions() const { return positions_; }
  Place place(std::size_t sample) const { return places_.empty() ? Place::inside : places_[sample]; }

  /// True when every sample is inside.
  bool inside() const { return places_.empty(); }
  bool inside(const QuadBlock& block) const;

  /// True when no sample is at infinity and no quad is torn.
  bool whole() const { return places_.empty() && torn_.empty(); }

  /// The first (row, column) of the given grid that is at infinity, or whose quad is torn.
  std::optional<std::array<std::size_t, 2>> first_clipped() const;

  /// Looks for quads through which the surface runs to infinity. Blocks without a step above `longest_step` hold none.
  void tear(const std::vector<QuadBlock>& blocks, const Cancel& cancel);

  /// Makes one of neighbors that coincide, on the sides of the quads of some blocks.
  void weld(const std::vector<QuadBlock>& blocks, const Cancel& cancel);

  /// Whether the surface runs through infinity inside a quad, going along rows or along columns.
  bool torn_along_rows(std::size_t quad) const { return !torn_.empty() && (torn_[quad] & along_rows) != 0; }
  bool torn_along_columns(std::size_t quad) const { return !torn_.empty() && (torn_[quad] & along_columns) != 0; }
  bool torn(std::size_t quad) const { return !torn_.empty() && torn_[quad] != 0; }
  bool torn() const { return !torn_.empty(); }

  /// The smallest sample that coincides with this one through a chain of coinciding neighbors.
  std::size_t label(std::size_t sample) const { return labels_.empty() ? sample : labels_[sample]; }

  /// Whether a sample coincides with a neighbor, so that differences along the grid say little about the surface there.
  bool merged(std::size_t sample) const { return !labels_.empty() && merged_[labels_[sample]] != 0; }
  bool merged() const { return !labels_.empty(); }

  /// Lengths up to this one, in meters, are round-off.
  double tolerance() const { return tolerance_; }

  /// Steps up to this length, in meters, never hold infinity.
  double longest_step() const;

  double clip_radius() const { return clip_radius_; }

 private:
  static constexpr std::uint8_t along_rows = 1, along_columns = 2;

  void read(const PointGrid& grid, const Cancel& cancel);
  void place_samples(const Cancel& cancel);
  bool has_short_sides(std::size_t row, std::size_t column) const;
  int tears_of(std::size_t row, std::size_t column) const;
  void unite(std::size_t a, std::size_t b);

  GridAxis rows_, columns_;
  Column<Point> copy_;  ///< of the points, when they lie in another order or not all of them are kept
  kernels::ConstPoints positions_ = {};
  Zeroed<Place> places_;          ///< empty when all are inside
  Zeroed<std::uint8_t> torn_;     ///< per quad, empty when none is torn
  Zeroed<std::uint32_t> labels_;  ///< empty when no neighbors coincide
  Zeroed<std::uint8_t> merged_;   ///< by label
  double largest_ = 0;            ///< coordinate of a sample inside
  double tolerance_ = 0;
  double clip_radius_ = 0;
};

}  // namespace dini
