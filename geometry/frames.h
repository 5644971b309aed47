#pragma once

#include <vector>

#include "geometry/cancel.h"
#include "geometry/curve_pieces.h"

namespace dini {

/// A place on a curve with a direction across it that does not turn about the curve.
struct Frame {
  Vector position;
  Vector tangent;    ///< unit
  Vector across;     ///< unit, perpendicular to the tangent
  double along = 0;  ///< length from the start of the piece, in meters
};

/// Rotation-minimizing frames at the points of a piece by double reflection (Wang, Juettler, Zheng, Liu 2008), fourth
/// order. Tangents are those of circles through three neighboring points. Around a closed piece the turn that is left
/// is spread evenly over its length; `total` receives the length of the piece, the closing step included.
/// Stopped early: frames that mean nothing.
std::vector<Frame> frames_along(const CurvePiece& piece, double& total, const Cancel& cancel);

}  // namespace dini
