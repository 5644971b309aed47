#include "algebra/vector.h"

#include <algorithm>

namespace dini {

namespace {

/// The power of two nearest below the largest component: dividing by it is exact.
double scale_of(const Vector& a) {
  const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

}  // namespace

double length(const Vector& a) {
  const double scale = scale_of(a);
  return scale * std::sqrt(squared_length(a / scale));
}

Vector normalized(const Vector& a) {
  const Vector scaled = a / scale_of(a);
  const double size = std::sqrt(squared_length(scaled));
  return size > 0 ? scaled / size : Vector{};
}

Vector any_perpendicular(const Vector& a) {
  const Vector unit = normalized(a);
  if (unit == Vector{}) return {1, 0, 0};
  const Vector least = std::abs(unit.x) <= std::abs(unit.y) && std::abs(unit.x) <= std::abs(unit.z) ? Vector{1, 0, 0}
                       : std::abs(unit.y) <= std::abs(unit.z)                                       ? Vector{0, 1, 0}
                                                                                                    : Vector{0, 0, 1};
  return normalized(cross(unit, least));
}

}  // namespace dini
