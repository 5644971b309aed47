#pragma once

#include <span>
#include <vector>

#include "geometry/scalar_field.h"

namespace dini {

/// How much wider than the ball a branch is kept for: values and bounds are rounded alike, to about 1e-16 of the
/// coordinates, and two neighboring balls must never disagree about the sign at a place that they share.
inline constexpr double narrowing_slack = 1e-7;

/// The minimum of numbers, rounded off where several are within `blend` of one another: the v below all of them with
/// sum max(0, v + blend - d)^2 = blend^2. Two planes at a right angle are joined by a fillet of radius `blend`. It does
/// not depend on the order; its derivatives, which go to `shares` if asked for, are not negative and sum to 1. A number
/// that is `blend` or more above the least has no part in it.
double rounded_minimum(std::span<const double> numbers, double blend, std::vector<double>* shares = nullptr);

/// The union of solids: the minimum of their fields, rounded off. There must be one at least.
SharedField union_field(std::vector<SharedField> fields, double blend);

/// What is in all of them: the maximum, rounded off in the same way.
SharedField intersection_field(std::vector<SharedField> fields, double blend);

/// The field with its solid and the space outside exchanged.
SharedField complement_field(SharedField field);

/// A ball that holds all of some balls.
SolidBall ball_around(const std::vector<SolidBall>& balls);

}  // namespace dini
