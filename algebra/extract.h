#pragma once

// Coordinates from elements: the inverse of algebra/construct.h.

#include <optional>

#include "algebra/elements.h"

namespace dini {

/// A circle or a line in coordinates. For a line `point` is its point nearest the origin.
struct CircleCoordinates {
  bool line = false;
  Point center;       ///< circle only
  Vector normal;      ///< circle only; unit, the circle runs counter-clockwise about it
  double radius = 0;  ///< circle only
  Point point;        ///< line only
  Vector direction;   ///< line only; unit
};

/// The coordinates of a circle; nothing for elements that are no circle (zero, or imaginary: negative squared radius).
/// It is a line when the weight |no_e| is below the round-off of the element (see algebra/tolerance.h).
std::optional<CircleCoordinates> coordinates(const Circle& circle);

/// A sphere or a plane in coordinates.
struct SphereCoordinates {
  bool plane = false;
  Point center;         ///< sphere only
  double radius = 0;    ///< sphere only
  Vector normal;        ///< plane only; unit
  double distance = 0;  ///< plane only; of the origin, along the normal
};
std::optional<SphereCoordinates> coordinates(const Sphere& sphere);

/// The point of a circle at `turn` (1 is once around, starting at a fixed direction in its plane that depends only on
/// the normal), or of a line at `turn` times `length` along it from its point nearest the origin, for turn in [-1/2,
/// 1/2].
Point point_at(const CircleCoordinates& circle, double turn, double length = 1);

}  // namespace dini
