#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh.h"
#include "graph/value.h"

namespace dini {

/// What there is to look at: control geometry is drawn in proportion to it, and what has no end ends at `reach`.
struct PreviewFrame {
  Vector center;
  double size = 1;    ///< from the center to the outermost thing that is not far off
  double reach = 10;  ///< from the origin
};

/// The frame of some values by medians, so that a few things near infinity do not stretch it. At most `elements` of
/// each value are looked at. Nothing with a place gives a frame of one meter about the origin. Stopped early: some
/// frame.
PreviewFrame frame_of(const std::vector<Value>& values, std::size_t elements, const Cancel& cancel);

/// Indices of at most `most` of `count` things, evenly spread, in order.
std::vector<std::size_t> spread_indices(std::size_t count, std::size_t most);

}  // namespace dini
