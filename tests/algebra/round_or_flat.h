#pragma once

// Random circles and spheres, some of which are flat.

#include "algebra/construct.h"
#include "tests/support/random_elements.h"

namespace dini::support {

/// The i-th of a sequence in which every `period`-th is a line.
inline Circle circle_or_line(RandomElements& random, int i, int period) {
  return i % period == 0 ? line_from(random.point(), random.vector())
                         : circle_from(random.point(), random.vector(), 0.2 + std::abs(random.number()));
}

/// The i-th of a sequence in which every third is a plane.
inline Sphere sphere_or_plane(RandomElements& random, int i) {
  return i % 3 == 0 ? plane_from(random.point(), random.vector())
                    : sphere_from(random.point(), 0.2 + std::abs(random.number()));
}

}  // namespace dini::support
