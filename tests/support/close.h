#pragma once

// Comparisons with a tolerance relative to the size of what is compared (at least one).

#include <algorithm>
#include <catch2/catch.hpp>

#include "algebra/elements.h"

namespace dini {

inline double distance(const Point& a, const Point& b) { return length(to_vector(a) - to_vector(b)); }

inline void require_close(const Point& value, const Point& expected, double tolerance = 1e-12) {
  INFO("value " << value.x << " " << value.y << " " << value.z << ", expected " << expected.x << " " << expected.y
                << " " << expected.z << ", off by " << distance(value, expected));
  REQUIRE(is_finite(value));
  REQUIRE(distance(value, expected) <= tolerance * std::max(1.0, length(to_vector(expected))));
}
inline void require_close(const Vector& value, const Vector& expected, double tolerance = 1e-12) {
  require_close(to_point(value), to_point(expected), tolerance);
}
inline double largest(const Generator& g) {
  return std::max({length(g.no_e), length(g.e_e), std::abs(g.no_ni), length(g.e_ni)});
}
inline void require_close(const Generator& value, const Generator& expected, double tolerance = 1e-12) {
  const double off = largest(value + -1.0 * expected);
  INFO("off by " << off);
  REQUIRE(off <= tolerance * std::max(1.0, largest(expected)));
}

}  // namespace dini
