#pragma once

// The flow of a generator: how exp(t B) moves a point at t = 0.

#include "algebra/elements.h"

namespace dini {

struct Flow {
  Vector velocity;       ///< meters per unit of t
  Vector acceleration;   ///< of the point as it goes along its orbit
  double curvature = 0;  ///< of the orbit, in 1/m; 0 where the point rests
  double torsion = 0;    ///< of the orbit, in 1/m; above 0 it winds like a right-handed screw, 0 where it is straight
};

/// The point must be finite. The velocity is the Euclidean part of the commutator of the generator and the point,
/// relative to its weight: "Boosted Surfaces", section 7.
Flow flow_at(const Generator& generator, const Point& point);

}  // namespace dini
