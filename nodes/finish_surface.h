#pragma once

#include <cstddef>

#include "geometry/axis.h"
#include "geometry/surface.h"
#include "graph/lift.h"

namespace dini {

/// The mesh through a grid of points, within the triangle budget of the evaluation. Where it leaves
/// the clip radius it is cut with a warning, or fails with `at-infinity`; the place is told along the consumed axis
/// `rows`, or as a row when the grid has no axes (null).
Attempt<SharedMesh> finish_surface(const Context& context, const PointGrid& grid, AtInfinity at_infinity,
                                   double clip_radius, const Axis* rows);

/// A bound of the vertices of a clipped grid of so many samples: of the three edges of each triangle at most two are
/// cut, and those of a grid share three edges for each sample.
inline std::size_t most_of_clipped_grid(std::size_t samples) { return 3 * samples; }

}  // namespace dini
