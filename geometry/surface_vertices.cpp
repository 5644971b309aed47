#include "geometry/surface_vertices.h"

#include <algorithm>

#include "geometry/number_table.h"

namespace dini {

SurfaceVertices::SurfaceVertices(const GridSamples& samples, const std::vector<SurfaceTile>& tiles,
                                 const Cancel& cancel)
    : sample_count_(samples.size()) {
  const bool all_regular =
      std::none_of(tiles.begin(), tiles.end(), [](const SurfaceTile& tile) { return tile.irregular.has_value(); });
  if (all_regular) return;
  Zeroed<std::uint8_t> used(samples.size());
  CancelEvery steps(cancel);
  for (const SurfaceTile& tile : tiles) {
    if (!tile.irregular) {
      for (std::size_t row = tile.block.row_begin; row <= tile.block.row_end; ++row) {
        std::uint8_t* const line = used.data() + samples.index(row % samples.rows().size(), 0);
        const std::size_t end = std::min(tile.block.column_end + 1, samples.columns().size());
        std::fill(line + tile.block.column_begin, line + end, std::uint8_t{1});
        if (tile.block.column_end == samples.columns().size()) line[0] = 1;
      }
      continue;
    }
    for (const auto& triangle : tile.irregular->triangles) {
      if (steps.stopped()) return;
      for (const std::uint32_t corner : triangle) {
        if (corner < samples.size()) used[corner] = 1;
      }
    }
  }
  numbers_ = Zeroed<std::uint32_t>(samples.size());
  std::uint32_t next = 0;
  for (std::size_t sample = 0; sample < samples.size() && !steps.stopped(); ++sample) {
    numbers_[sample] = used[sample] != 0 ? next++ : none;
  }
  sample_count_ = next;
  number_cuts(tiles, cancel);
}

void SurfaceVertices::number_cuts(const std::vector<SurfaceTile>& tiles, const Cancel& cancel) {
  // A cut that lost all of its triangles is no vertex, so cuts are numbered as triangles use them.
  NumberTable number_of;
  for (const SurfaceTile& tile : tiles) {
    first_cut_.push_back(cut_numbers_.size());
    if (!tile.irregular || cancel.stopped()) continue;
    const IrregularTile& irregular = *tile.irregular;
    std::vector<std::uint8_t> used(irregular.cuts.size());
    const std::size_t samples = numbers_.size();
    for (const auto& triangle : irregular.triangles) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= samples) used[corner - samples] = 1;
      }
    }
    for (std::size_t k = 0; k < irregular.cuts.size(); ++k) {
      const CutVertex& cut = irregular.cuts[k];
      std::uint32_t number = none;
      if (used[k] != 0) {
        const auto fresh = static_cast<std::uint32_t>(size());
        const auto [known, added] = number_of.try_emplace(std::uint64_t{cut.from} << 32 | cut.to, fresh, cancel);
        if (added) cuts_.push_back(cut);
        number = known;
      }
      cut_numbers_.push_back(number);
    }
  }
}

}  // namespace dini
