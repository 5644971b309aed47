#include "geometry/grid_tear.h"

#include "geometry/clip.h"

namespace dini {

bool holds_infinity(const QuadShape& before, const QuadShape& quad, const QuadShape& after, double least_step) {
  if (!quad.known || (!before.known && !after.known)) return false;
  const double step = length(quad.step);
  if (step <= least_step) return false;
  // At a border the missing neighbor is taken to be as long as the other one.
  const double step_before = length(before.known ? before.step : after.step);
  const double step_after = length(after.known ? after.step : before.step);
  if (step <= step_before + step_after) return false;
  return (!before.known || opposes(before.area, quad.area)) && (!after.known || opposes(quad.area, after.area));
}

}  // namespace dini
