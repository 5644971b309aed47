#pragma once

#include <functional>
#include <span>

#include "fitting/varied.h"

namespace dini::fitting {

/// What is to be as small as it can: all functions of a place. A function is given where to write the slopes when they
/// are wanted, and an empty span when not.
struct Objective {
  std::function<double(const Place&, std::span<double> slopes)> value;
  std::size_t conditions = 0;  ///< how many values must be 0
  /// Their values, and their slopes condition by condition.
  std::function<void(const Place&, std::span<double> values, std::span<double> slopes)> missing;
  std::function<bool()> stopped;  ///< whether to give up; asked at every evaluation
  /// The search ends when a step betters the value by less than this part of it; 0 for no such end.
  double least_gain = 0;
};

/// Goes downhill from a place, within 0 and 1, by sequential quadratic programming (NLopt's SLSQP), until steps are
/// below 1e-9 or `stopped` says so. The place where it ended; what functions were asked on the way is for them to know.
Place minimize(const Objective& objective, const Place& start);

}  // namespace dini::fitting
