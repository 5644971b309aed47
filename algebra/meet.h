#pragma once

// What two elements have in common, and spheres through points.

#include <optional>

#include "algebra/elements.h"

namespace dini {

/// How two elements meet. Touching is decided to the round-off of their places and sizes.
enum class Meeting { apart = -1, touching = 0, crossing = 1 };

/// What two spheres or planes have in common. Where they touch, `circle` is the one of radius zero there. Apart it has
/// radius zero too, since an imaginary circle has no place on a wire: it stands in the plane in which the spheres would
/// meet, at the center of spheres about one center, and half way between parallel planes, which touch at infinity.
/// It runs counter-clockwise about the way from the center of the first sphere to that of the second, a line along the
/// cross product of the normals.
struct SphereMeeting {
  Meeting kind = Meeting::apart;
  Circle circle;
  Point a = Point::at_infinity();  ///< on the circle where `point_at` starts, or where they touch
  Point b = Point::at_infinity();  ///< opposite to it; of a line, infinity
};

/// Nothing where they are one sphere, or where one is none.
std::optional<SphereMeeting> meet(const Sphere& first, const Sphere& second);

/// What a circle or line and a sphere or plane have in common: a pair of points, with its coordinates. A line and a
/// plane cross in a point and at infinity: a flat point. Apart, the pair is imaginary, and its points at infinity.
struct CircleMeeting {
  Meeting kind = Meeting::apart;
  Generator pair;                  ///< of unit tangent, from b to a
  Point a = Point::at_infinity();  ///< where the circle leaves the sphere, or the side that a plane's normal points to
  Point b = Point::at_infinity();  ///< where it enters
};

/// Nothing where the circle lies in the sphere, or where one is none.
std::optional<CircleMeeting> meet(const Circle& circle, const Sphere& sphere);

/// The sphere through four points; the plane when they lie in one, or when one is at infinity. A plane's normal is
/// that of a, b, c run counter-clockwise. Nothing when many spheres pass through them: when two agree, or all lie on
/// one circle or line.
std::optional<Sphere> sphere_through(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace dini
