#pragma once

#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// What the frames along a curve follow, besides the curve.
enum class FrameRule {
  steady,     ///< they turn about the curve as little as they can, and start near the direction up
  curvature,  ///< their z is the direction to the center of curvature
  upright,    ///< their z is the direction up, and only their heading follows the curve
};

/// A place with three perpendicular unit directions, x along the curve (or its heading), z as the rule says, y = z x x.
struct PlacedFrame {
  Vector place, x, y, z;
};

/// A frame at each point of a curve. Points of the curve are finite and below 1e18. Points that agree to round-off
/// have the frame of the first of them; a curve of one place has x along e1 (or what of it is perpendicular to z) and z
/// up, or the axes of space where up is zero. Where the curve is straight, frames of `curvature` go on as steady ones.
/// Where the curve runs along up, upright frames keep the heading that they had. Steady frames of a closed curve close:
/// the turn that is left is spread evenly. A zero `up` counts as e3. Stopped early: frames that mean nothing.
std::vector<PlacedFrame> curve_frames(const Polyline& curve, FrameRule rule, const Vector& up, const Cancel& cancel);

}  // namespace dini
