#include "algebra/flow.h"

#include "algebra/frame.h"
#include "algebra/tolerance.h"

namespace dini {

Flow flow_at(const Generator& generator, const Point& point) {
  // From the point itself the commutator 2 B . P has the velocity -2 M and no weight, and the derivative of the field
  // is h -> 2 h x W + 2 e h, its second one (h, h) -> 2 h^2 A - 4 (A.h) h.
  const auto [A, W, e, M] = seen_from(generator, to_vector(point));
  Flow flow;
  flow.velocity = -2.0 * M;
  flow.acceleration = 2.0 * cross(flow.velocity, W) + (2 * e) * flow.velocity;
  const double speed = length(flow.velocity);
  if (speed == 0 || !is_finite(flow.velocity)) return flow;
  // What bends the orbit is the part of W across it; with it the third derivative comes down to this.
  const Vector ahead = flow.velocity / speed;
  const double along = dot(ahead, W);
  const Vector bend = W - along * ahead;
  const double size = length(bend);
  flow.curvature = 2 * size / speed;
  if (size <= tolerance::square_noise * length(W) || !(size > 0)) {
    flow.curvature = 0;
    return flow;
  }
  flow.torsion = -(dot(A, bend / size) / size + 2 * along / speed);
  return flow;
}

}  // namespace dini
