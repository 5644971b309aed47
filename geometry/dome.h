#pragma once

#include <vector>

#include "algebra/vector.h"

namespace dini {

/// A loop of places as its dome sees it: counter-clockwise seen from outside.
struct Rim {
  std::vector<Vector> places;
  std::vector<Vector> tangents;  ///< how the surface goes on beyond each place, of length 1
};

/// How a dome stands on a rim.
struct DomeShape {
  Vector middle;  ///< of the rim
  Vector normal;  ///< of its mean plane, outward; zero for a rim without area
  Vector apex;
};

/// The dome that goes on from a rim as its tangents do: on a circle with even tangents it is a part of the sphere that
/// is tangent there. Its apex stands over the middle, at most four radii away.
DomeShape dome_shape(const Rim& rim);

/// The places at `share` of the way from the rim (0) to the apex (1), each on the circle through the apex that is
/// tangent to the surface at its place on the rim. Where the tangent points away from the apex by more than 150
/// degrees, the circle leaves at that angle.
std::vector<Vector> dome_ring(const Rim& rim, const Vector& apex, double share);

}  // namespace dini
