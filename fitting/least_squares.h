#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fitting/matrix.h"
#include "fitting/varied.h"

namespace dini::fitting {

/// Numbers whose squares are to be as small as they can together.
struct SquaresProblem {
  /// The numbers at a place; nothing where there are none.
  std::function<std::optional<std::vector<double>>(const Place&)> values;
  /// How they grow, by parameter, at a place that `values` was asked for last.
  std::function<std::vector<std::vector<double>>(const Place&)> slopes;
  std::function<bool()> stopped;  ///< whether to give up; asked before each evaluation
};

/// Goes to the bottom of the valley that a place is in, within 0 and 1, by the steps of Levenberg and Marquardt: near
/// the end each is as good as the square of the one before, where the numbers vanish.
Place least_squares(const SquaresProblem& problem, const Place& start);

/// Products of the slopes with each other: how sharply the sum of squares rises in each direction.
SymmetricMatrix normal_matrix(const std::vector<std::vector<double>>& slopes);

double dot_product(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace dini::fitting
