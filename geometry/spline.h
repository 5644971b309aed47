#pragma once

#include <vector>

#include "geometry/cancel.h"
#include "geometry/column.h"

namespace dini {

enum class SplineKind {
  centripetal,  ///< Catmull-Rom: tangents from neighbors; each point moves the curve near it only, without loops
  smooth,       ///< a cubic spline whose curvature is continuous too; each point moves all of it a little
};

enum class SplineSpacing {
  length,  ///< at even lengths of the curve
  points,  ///< the same number of steps between given neighbors, where the count allows it: given points are kept
};

struct SplineOptions {
  SplineKind kind = SplineKind::centripetal;
  SplineSpacing spacing = SplineSpacing::length;
  bool closed = false;
  std::size_t count = 64;
};

/// `count` points of the cubic curve through the given points in their order, closed back to the first or open. An open
/// one holds both ends, a closed one its start only once.
///
/// Knots are centripetal: steps of the parameter are square roots of distances, which keeps curves free of cusps and
/// loops between neighbors (Yuksel, Schaefer, Keyser, "Parameterization and applications of Catmull-Rom curves", 2011).
/// An open smooth curve has no curvature at its ends. Points that agree with the one before them are one; a single
/// point, or none but equal ones, gives that point `count` times, and two an even straight line, closed there and back.
/// Points are finite and below 1e18; no points give none. Even lengths are right to a part of the square of the bend of
/// a 64th of the step between given points. Stopped early: points that mean nothing.
Column<Point> spline_points(const Column<Point>& given, const SplineOptions& options, const Cancel& cancel);

}  // namespace dini
