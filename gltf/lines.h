#pragma once

// Polylines and points as float arrays: what glTF can draw of them. A point at infinity (or beyond 1e18) cannot be
// drawn.

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace dini {

using FloatPoints = std::vector<std::array<float, 3>>;

/// The drawable runs of `polyline`, two points or more each. Points that cannot be drawn split it; a closed polyline
/// that is whole repeats its first point at the end, and a split one keeps the run that crosses its start in one piece.
std::vector<FloatPoints> drawable_runs(const Polyline& polyline);

/// The points that can be drawn, in order.
FloatPoints drawable_points(const Column<Point>& points);

}  // namespace dini
