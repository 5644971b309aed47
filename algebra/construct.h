#pragma once

// Elements from coordinates. Every function is total: the degenerate cases are part of each contract.

#include "algebra/elements.h"

namespace dini {

/// The null point pair (translated tangent) T(c, t) = no^t + (c.t) no^ni + c^t + ((c.t) c - c^2/2 t)^ni.
/// Paper, eqs. (1), (4). A zero tangent gives the zero generator.
Generator null_pair(const Point& position, const Vector& tangent);

/// T(c, t) - split t^ni, whose square is 2 split |t|^2: real for split > 0, null for 0, imaginary below. Paper, fig. 8.
Generator split_pair(const Point& position, const Vector& tangent, double split);

/// The flat point p^ni: exp(k p^ni) scales about p by e^(2k). Paper, section 4.
Generator flat_point(const Point& position);

/// The direction v^ni: exp(k v^ni) translates by -2 k v.
Generator direction_generator(const Vector& direction);

/// The unit dual line of `axis` (e_e = unit direction u): exp(-angle/2 B) turns by `angle` about it, right hand.
/// For a circle, the unit generator of the turn along it. A degenerate circle gives the zero generator.
Generator rotation_generator(const Circle& axis);

/// Scalar and bivector part of the geometric product of two weighted points w no + x + x^2/2 ni. Paper, eq. (19).
struct PointProduct {
  double scalar = 0;
  Generator generator;
};
PointProduct point_product(const Point& a, double weight_a, const Point& b, double weight_b);

/// The circle about `normal` (any length; zero gives the zero element, which is no circle), counter-clockwise.
Circle circle_from(const Point& center, const Vector& normal, double radius);

/// The line through `point` along `direction` (any length; zero gives the zero element).
Circle line_from(const Point& point, const Vector& direction);

/// The circle through a, b, c in this order; the line from a to c when they are collinear; the zero element when two
/// agree.
Circle circle_through(const Point& a, const Point& b, const Point& c);

/// The dual sphere no + c + (c^2 - r^2)/2 ni.
Sphere sphere_from(const Point& center, double radius);

/// The dual plane n + (p.n) ni with unit n along `normal`; the zero element for a zero normal.
Sphere plane_from(const Point& point, const Vector& normal);

}  // namespace dini
