#pragma once

#include <cmath>

#include "algebra/vector.h"
#include "graph/context.h"
#include "graph/literal.h"

namespace dini {

/// Whether less than half of the digits that a picture needs are left of a radius: an element far from the origin holds
/// the difference of the squares of its distance and its radius.
inline bool lost(double held, double radius) { return radius > 0 && !(std::abs(held - radius) <= 1e-3 * radius); }

/// What is said of a circle or sphere that its coefficients cannot hold.
inline Failure too_far_for(double radius, const Point& center) {
  return {"out-of-range",
          "a radius of " + to_text(radius) + " m cannot be told from zero " + to_text(length(to_vector(center))) +
              " m from the origin, in double precision; bring it nearer, or make it larger",
          "center"};
}

}  // namespace dini
