#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/mesh.h"
#include "graph/context.h"

namespace dini {

/// Two counts, of segments one way and the other.
struct Segments {
  std::size_t along = 0;
  std::size_t across = 0;
};

/// The counts that a mesh of quads was asked to have, both made smaller alike where that would be more triangles than
/// the budget of the evaluation; never below `least`, nor above what was asked.
Segments within_budget(const Context& context, std::int64_t along, std::int64_t across, Segments least);

/// The points and sides of a tube, which is as thin as it has to be round: sides go first, to six, then points, to
/// eight, then both. A tube of fewer than six sides has no caps.
struct TubeSegments {
  std::size_t points = 0;
  std::size_t sides = 0;
  bool capped = true;
};
TubeSegments tube_within_budget(const Context& context, std::size_t points, bool closed, std::int64_t sides);

/// How few points a curve can be thinned to without vanishing: more where it comes back to its start.
std::size_t fewest_points(const Polyline& curve);

/// Evenly chosen points of a curve; the ends of an open one stay.
Polyline thinned(const Polyline& curve, std::size_t points);

}  // namespace dini
