#pragma once

// Normals of a grid surface from differences of its samples.

#include <array>
#include <optional>

#include "geometry/grid_samples.h"

namespace dini {

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

 private:
  Vector derivative(std::size_t sample, bool along_rows) const;

  const GridSamples& samples_;
  Zeroed<Stencil> row_stencils_, column_stencils_;  ///< those of samples that nothing obstructs
};

}  // namespace dini
