#pragma once

// Normals of a grid surface from differences of its samples.

#include <array>
#include <optional>

#include "geometry/grid_samples.h"

namespace dini {

/// A tangent this small against the steps around it is what cancellation left of a turning point.
inline constexpr double vanishing_tangent = 1e-3;

/// Tangents whose angle has a smaller sine are parallel.
inline constexpr double parallel_tangents = 1e-6;

/// Weights of a first derivative at a sample: `count` samples from `first` steps before it.
struct Stencil {
  std::size_t first = 0, count = 0;
  std::array<double, 5> weights = {};
};

/// Unit normals along (row direction) x (column direction) at samples of a grid. Derivatives use five samples where
/// there are, centered where possible, and never reach over a border, a sample at infinity or a torn quad.
class GridNormals {
 public:
  GridNormals(const GridSamples& samples, const Cancel& cancel);

  /// The normal at a finite sample; nothing where a tangent vanishes or both are parallel.
  std::optional<Vector> at(std::size_t sample) const;

  /// The normals at all samples, as if none were at infinity, no quad torn and no two neighbors the same. Where there
  /// is none it is zero, and the byte of the sample in `doubtful` becomes 1.
  Column<Vector> all(Zeroed<std::uint8_t>& doubtful, const Cancel& cancel) const;

  /// Makes 1 of the bytes of all samples that this may be wrong for.
  void doubt_obstructed(Zeroed<std::uint8_t>& doubtful, const Cancel& cancel) const;

 private:
  Vector derivative(std::size_t sample, bool along_rows) const;
  void row_of_normals(std::size_t row, kernels::Points normals, std::uint8_t* doubtful) const;

  const GridSamples& samples_;
  Zeroed<Stencil> row_stencils_, column_stencils_;  ///< those of samples that nothing obstructs
  std::array<Zeroed<double>, 4> column_weights_;    ///< of the stencils of all columns but two at either end
};

}  // namespace dini
