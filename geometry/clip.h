#pragma once

#include <algorithm>
#include <cmath>

#include "algebra/vector.h"

namespace dini {

/// Lengths up to this part of the largest coordinate are round-off: positions come out of a few dozen roundings.
inline constexpr double relative_round_off = 1e-12;

/// Keeps everything that passes below the largest coordinate a mesh may hold.
inline constexpr double largest_clip_radius = 1e17;

/// Steps below this part of the clip radius are ordinary, however much they turn; longer ones may hold infinity.
inline constexpr double ordinary_step = 1e-2;

/// Directions whose cosine is below this are opposite; those of an equilateral triangle (-0.5) are not.
inline constexpr double opposite = -0.75;

inline bool opposes(const Vector& a, const Vector& b) { return dot(a, b) < opposite * length(a) * length(b); }

inline double largest_component(const Vector& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The length from `start`, inside the sphere of `radius` around the origin, along the unit `direction` to the sphere.
inline double length_to_sphere(const Vector& start, const Vector& direction, double radius) {
  const double along = dot(start, direction);
  const double size = length(start);
  const double rest = std::max(0.0, (radius - size) * (radius + size));
  // Of the two forms of the root the one that does not cancel.
  const double root = std::sqrt(along * along + rest);
  return along > 0 ? rest / (along + root) : root - along;
}

}  // namespace dini
