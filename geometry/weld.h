#pragma once

#include <cstdint>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/column.h"

namespace dini {

/// For every position the smallest index that holds exactly the same coordinates (0 and -0 count as the same).
/// Meshes that double vertices along texture seams or sharp edges become connected again through these labels.
/// At most 2^31 positions. Stopped early: zeros.
std::vector<std::uint32_t> position_labels(const Column<Point>& positions, const Cancel& cancel);

}  // namespace dini
