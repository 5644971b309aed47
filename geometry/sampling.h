#pragma once

#include <cmath>
#include <cstddef>

#include "geometry/cancel.h"
#include "geometry/column.h"

namespace dini {

/// `count` evenly spaced numbers from `from` to `to`, in that order; both ends are exact.
/// Open: sample i lies at i/(count-1), both ends are included. Closed: sample i lies at i/count, so `to` is left out
/// and no sample is doubled when the last joins the first. A count of 1 gives `from`, a count of 0 nothing.
/// Stopped early: zeros after the first ones.
inline Column<double> spaced(double from, double to, std::size_t count, bool closed, const Cancel& cancel) {
  Column<double> samples(count);
  const std::size_t steps = closed ? count : count - 1;
  CancelEvery looks(cancel);
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) {
    const double ahead = static_cast<double>(i);
    const double whole = static_cast<double>(steps);
    double value = from;
    if (i == steps && i > 0) {
      value = to;
    } else if (i > 0 && from != to) {
      // One division of a sum that is exact for small whole numbers: 0..1 gives the double nearest to i/steps.
      value = (from * (whole - ahead) + to * ahead) / whole;
      if (!std::isfinite(value)) value = std::lerp(from, to, ahead / whole);
    }
    samples.set(i, value);
  }
  return samples;
}

}  // namespace dini
