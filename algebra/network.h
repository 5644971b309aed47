#pragma once

// A network of weighted points that carry one another.
//
// Seen from the middle of two points, the one at -h and the other at h, the product of eq. (19) of "Boosted Surfaces"
// with weights w_i, w_j of the no coefficient has the bivector part
//   (w_i + w_j) no^h + (w_i - w_j) h^2/2 no^ni - h^2 h^ni.
// It moves the first point with the velocity 2 (1 - w_i) h^2 h: towards the other for a weight below 1, away from it
// above, and not at all for the weight 1, with which both points are the poles of their pair.

#include <cstddef>
#include <cstdint>

#include "algebra/kernels.h"

namespace dini::kernels {

/// How the points of a network carry one another, and what keeps them.
struct NetworkSettings {
  double strength = 1;  ///< factor of every product (eq. 20)
  double power = 2;     ///< the product with a neighbor at distance d is weighted by 1 / (d^power + softening)
  double softening = 0;
  double rest = 0;     ///< in meters: nearer than this the product acts the other way, by the factor 1 - (rest / d)^2
  double damping = 1;  ///< share of the last step that is lost: 1 all of it, 0 none
  double longest_step = 1;  ///< in meters
  Point center;             ///< of the ball that no point leaves
  double radius = 100;      ///< of that ball, in meters
};

/// The neighbors of every point: neighbor m of point i is indices[m * count + i]. A point that is given as its own
/// neighbor has one less. Without indices every point is a neighbor of every other.
struct Neighbors {
  const std::uint32_t* indices = nullptr;
  std::size_t each = 0;
};

/// The points of a network at one moment, `count` of them, each with its weight.
struct Network {
  ConstPoints points;
  const double* weights;
  std::size_t count;
  Neighbors neighbors;
};

/// One step of the points [begin, end): each goes where exp of the weighted sum of its products carries it, plus what
/// is left of its last step; `steps` holds that, and gets what it goes now. The step is cut to the longest one, and
/// what leaves the ball is put back on it. A point that would be carried to infinity stays, but for its last step, and
/// points at one place do nothing to one another. `out` must not be the points themselves. Asks `stop` between points
/// that have all others as their neighbors.
void step_network(const NetworkSettings& settings, const Network& network, std::size_t begin, std::size_t end,
                  Points steps, Points out, Stop stop = {});

}  // namespace dini::kernels
