#pragma once

#include "algebra/construct.h"
#include "algebra/versor.h"
#include "geometry/field_blend.h"
#include "geometry/field_motion.h"
#include "geometry/field_offset.h"
#include "geometry/field_shapes.h"
#include "tests/support/random_elements.h"

namespace dini::support {

/// A boost of moderate strength.
inline Versor random_boost(RandomElements& random) {
  return exponential(null_pair(random.point(1.5), random.vector(0.3)));
}

inline SharedField moved(const SharedField& field, const Versor& versor) { return moved_field(field, versor).value(); }

inline SharedField random_shape(RandomElements& random) {
  const double kind = random.number();
  const double size = 0.5 + 0.3 * random.number();
  if (kind < -0.6) return ring_field(random.vector(), normalized(random.vector()), size, 0.3 * size);
  if (kind < -0.3) return rod_field(random.vector(), normalized(random.vector()), 0.4 * size);
  if (kind < 0) return plane_field(normalized(random.vector()), random.number());
  if (kind < 0.4) {
    Column<Point> centers(5);
    for (std::size_t i = 0; i < 5; ++i) centers.set(i, random.point());
    return balls_field(std::move(centers), 0.5 * size, 0.2 * size, Cancel());
  }
  return sphere_field(random.vector(), size);
}

/// A tree of everything that there is, over about two to the `depth` shapes.
inline SharedField random_field(RandomElements& random, int depth) {
  if (depth == 0) return random_shape(random);
  const SharedField a = random_field(random, depth - 1), b = random_field(random, depth - 1);
  const double kind = random.number(), blend = random.number() < 0 ? 0 : 0.2 + 0.1 * random.number();
  SharedField both = kind < -0.3  ? union_field({a, b}, blend)
                     : kind < 0.2 ? intersection_field({a, b}, blend)
                                  : intersection_field({a, complement_field(b)}, blend);
  const double then = random.number();
  if (then < -0.4) return moved(both, random_boost(random));
  if (then < 0) return offset_field(both, random.number(0.1));
  if (then < 0.3) return shell_field(both, 0.2, 0.1 + random.number(0.1));
  return both;
}

}  // namespace dini::support
