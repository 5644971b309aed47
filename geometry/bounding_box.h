#pragma once

#include <algorithm>
#include <limits>

#include "algebra/vector.h"

namespace dini {

/// The axis-parallel box around some points: none at first, with `low` above `high`.
struct BoundingBox {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Vector low{infinity, infinity, infinity};
  Vector high{-infinity, -infinity, -infinity};

  void add(const Vector& point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
  }

  /// Whether two boxes have a place in common.
  bool meets(const BoundingBox& other) const {
    return low.x <= other.high.x && low.y <= other.high.y && low.z <= other.high.z && high.x >= other.low.x &&
           high.y >= other.low.y && high.z >= other.low.z;
  }

  Vector middle() const { return low + 0.5 * (high - low); }

  /// From a point to the nearest place in the box: 0 inside, infinite where there is no point.
  double squared_distance(const Vector& point) const {
    const auto outside = [](double value, double least, double most) {
      return value < least ? least - value : std::max(value - most, 0.0);
    };
    return squared_length(
        {outside(point.x, low.x, high.x), outside(point.y, low.y, high.y), outside(point.z, low.z, high.z)});
  }
};

}  // namespace dini
