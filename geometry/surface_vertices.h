#pragma once

// Which samples and cuts of a surface become vertices, and their numbers.

#include <cstdint>
#include <vector>

#include "geometry/surface_tiles.h"

namespace dini {

/// The vertices of a surface: samples that triangles use in the order of the grid, then cuts in that of the tiles.
class SurfaceVertices {
 public:
  SurfaceVertices(const GridSamples& samples, const std::vector<SurfaceTile>& tiles, const Cancel& cancel);

  std::size_t size() const { return sample_count_ + cuts_.size(); }
  std::size_t sample_count() const { return sample_count_; }
  const std::vector<CutVertex>& cuts() const { return cuts_; }

  /// Whether the vertices are all samples, each with the number that it has in the grid.
  bool are_samples() const { return numbers_.empty(); }

  /// Whether a sample is a vertex; one that coincides with a smaller one is none.
  bool uses(std::size_t sample) const { return are_samples() || numbers_[sample] != none; }

  /// The number of a sample that is a vertex.
  std::uint32_t of_sample(std::size_t sample) const {
    return are_samples() ? static_cast<std::uint32_t>(sample) : numbers_[sample];
  }

  /// The number of cut `cut` of tile `tile`.
  std::uint32_t of_cut(std::size_t tile, std::size_t cut) const { return cut_numbers_[first_cut_[tile] + cut]; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  void number_cuts(const std::vector<SurfaceTile>& tiles, const Cancel& cancel);

  std::size_t sample_count_ = 0;
  Zeroed<std::uint32_t> numbers_;
  std::vector<CutVertex> cuts_;
  std::vector<std::size_t> first_cut_;  ///< of each tile in `cut_numbers_`
  std::vector<std::uint32_t> cut_numbers_;
};

}  // namespace dini
