#pragma once

// Polylines and points as float arrays: what glTF can draw of them. A point at infinity (or beyond 1e18) cannot be
// drawn.

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

using FloatPoints = std::vector<std::array<float, 3>>;

/// Runs of points joined by segments, one after another in one array: run k ends before `ends[k]`.
struct FloatRuns {
  FloatPoints points;
  std::vector<std::size_t> ends;
};

/// Adds the drawable runs of `polyline`, two points or more each. Points that cannot be drawn split it; a closed
/// polyline that is whole repeats its first point at the end, and a split one keeps the run that crosses its start in
/// one piece. Stopped early: not all of them.
void add_drawable_runs(const Polyline& polyline, FloatRuns& runs, const Cancel& cancel);

/// The points that can be drawn, in order. Stopped early: the first of them.
FloatPoints drawable_points(const Column<Point>& points, const Cancel& cancel);

}  // namespace dini
