#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "algebra/vector.h"
#include "geometry/cancel.h"

namespace dini {

/// Unit directions in space; the zero vector where there is none.
using DirectionField = std::function<Vector(const Vector&)>;

struct FieldLineOptions {
  double length = 1;         ///< meters, at most so much of the line; below 0 it runs against the field
  std::size_t count = 2;     ///< points, ends included
  double clip_radius = 1e3;  ///< meters from the origin
  bool both_ways = false;  ///< a line that does not close runs from its other end, `length` on either side of the start
};

struct FieldLine {
  std::vector<Vector> points;  ///< `count` of them, at even distances along the line
  double length = 0;           ///< of the line that is left, not negative
  bool closed = false;         ///< the last point is the first
};

/// The line through `start` along a field of directions, by the classical Runge-Kutta method in steps that turn by at
/// most a tenth of a radian and are short beside the distance over which the field changes. It ends after `length`,
/// where it closes, where it leaves the clip radius, and where the
/// field gives no direction or changes so fast that the line would take no end of steps: at a fixed point, which it
/// reaches to about 1e-4 of its length. The points are spread evenly over what there is: all are `start` when that
/// is nothing, or beyond the clip radius.
///
/// A line closes when it comes back, in its first direction, to within 2 % of the way it has gone; fields that are
/// known only by finite displacements miss by that much. What is missing is spread over the points.
/// Stopped early: all points are `start`.
FieldLine field_line(const DirectionField& field, const Vector& start, const FieldLineOptions& options,
                     const Cancel& cancel);

}  // namespace dini
