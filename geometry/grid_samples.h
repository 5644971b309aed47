#pragma once

// The samples of a grid that becomes a surface: where they are, which of them are at infinity, where the surface was
// torn by running through infinity between samples, and which neighbors coincide.

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/grid_axis.h"
#include "geometry/surface.h"
#include "geometry/zeroed.h"

namespace dini {

/// Where a sample lies: within the clip radius, finite but beyond it, or not finite.
enum class Place : std::uint8_t { infinite, outside, inside };

/// A thinned grid, read once. Sample (row, column) has the index row * columns.size() + column; quad (row, column) lies
/// between that sample and the next ones along both axes and has the same index. Stopped early: what it tells means
/// nothing.
class GridSamples {
 public:
  GridSamples(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel);

  const GridAxis& rows() const { return rows_; }
  const GridAxis& columns() const { return columns_; }
  std::size_t size() const { return positions_.size(); }
  std::size_t index(std::size_t row, std::size_t column) const { return row * columns_.size() + column; }
  std::size_t row_of(std::size_t sample) const { return sample / columns_.size(); }
  std::size_t column_of(std::size_t sample) const { return sample % columns_.size(); }

  const Vector& position(std::size_t sample) const { return positions_[sample]; }
  Place place(std::size_t sample) const { return places_[sample]; }

  /// True when no sample is at infinity and no quad is torn.
  bool whole() const { return !first_clipped_; }

  /// The first (row, column) of the given grid that is at infinity, or whose quad is torn.
  const std::optional<std::array<std::size_t, 2>>& first_clipped() const { return first_clipped_; }

  /// Whether the surface runs through infinity inside a quad, going along rows or along columns.
  bool torn_along_rows(std::size_t quad) const { return !torn_.empty() && (torn_[quad] & along_rows) != 0; }
  bool torn_along_columns(std::size_t quad) const { return !torn_.empty() && (torn_[quad] & along_columns) != 0; }
  bool torn(std::size_t quad) const { return !torn_.empty() && torn_[quad] != 0; }

  /// The smallest sample that coincides with this one through a chain of coinciding neighbors.
  std::size_t label(std::size_t sample) const { return labels_[sample]; }

  /// Whether a sample coincides with a neighbor, so that differences along the grid say little about the surface there.
  bool merged(std::size_t sample) const { return merged_[labels_[sample]]; }

  /// Lengths up to this one, in meters, are round-off.
  double tolerance() const { return tolerance_; }

  double clip_radius() const { return clip_radius_; }

 private:
  static constexpr std::uint8_t along_rows = 1, along_columns = 2;

  void read(const PointGrid& grid, const Cancel& cancel);
  void tear(const Cancel& cancel);
  void weld(const Cancel& cancel);
  void unite(std::size_t a, std::size_t b);
  void note_clipped(std::size_t sample);

  GridAxis rows_, columns_;
  Zeroed<Vector> positions_;
  Zeroed<Place> places_;
  Zeroed<std::uint8_t> torn_;  ///< per quad, empty when none is torn
  Zeroed<std::uint32_t> labels_;
  std::vector<bool> merged_;
  std::optional<std::array<std::size_t, 2>> first_clipped_;
  double largest_ = 0;  ///< coordinate of a sample inside
  double tolerance_ = 0;
  double clip_radius_ = 0;
};

}  // namespace dini
