#include "fitting/least_squares.h"

#include <algorithm>
#include <cmath>

namespace dini::fitting {
namespace {

constexpr int most_steps = 60;
constexpr double least_step = 1e-10;
constexpr double first_damping = 1e-3, least_damping = 1e-12, most_damping = 1e8;

/// The step with this damping. A parameter at a bound that the sum falls beyond stays where it is.
std::optional<Place> stepped(const Place& place, const SymmetricMatrix& normal, const std::vector<double>& slope,
                             double damping) {
  std::vector<std::size_t> open;
  double largest = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const bool is_held = (place[k] <= 0 && slope[k] >= 0) || (place[k] >= 1 && slope[k] <= 0);
    if (!is_held) open.push_back(k);
    largest = std::max(largest, normal(k, k));
  }
  if (open.empty() || !(largest > 0)) return std::nullopt;
  SymmetricMatrix damped(open.size());
  std::vector<double> right;
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (std::size_t j = 0; j < open.size(); ++j) damped(i, j) = normal(open[i], open[j]);
    // The second part keeps parameters that change nothing where they are.
    damped(i, i) += damping * normal(open[i], open[i]) + 1e-12 * largest;
    right.push_back(-slope[open[i]]);
  }
  const auto step = solve(std::move(damped), std::move(right));
  if (!step) return std::nullopt;
  Place next = place;
  for (std::size_t i = 0; i < open.size(); ++i) next[open[i]] = std::clamp(place[open[i]] + (*step)[i], 0.0, 1.0);
  return next;
}

double farthest(const Place& a, const Place& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

}  // namespace

double dot_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

SymmetricMatrix normal_matrix(const std::vector<std::vector<double>>& slopes) {
  SymmetricMatrix normal(slopes.size());
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    for (std::size_t j = i; j < slopes.size(); ++j) normal(i, j) = normal(j, i) = dot_product(slopes[i], slopes[j]);
  }
  return normal;
}

Place least_squares(const SquaresProblem& problem, const Place& start) {
  Place place = start;
  if (problem.stopped()) return place;
  std::optional<std::vector<double>> values = problem.values(place);
  double damping = first_damping;
  for (int step = 0; step < most_steps && values && !problem.stopped(); ++step) {
    const std::vector<std::vector<double>> slopes = problem.slopes(place);
    const SymmetricMatrix normal = normal_matrix(slopes);
    std::vector<double> slope;
    for (const std::vector<double>& each : slopes) slope.push_back(dot_product(each, *values));
    bool went = false;
    while (!went && damping <= most_damping && !problem.stopped()) {
      const std::optional<Place> next = stepped(place, normal, slope, damping);
      if (!next || farthest(*next, place) < least_step) return place;
      std::optional<std::vector<double>> there = problem.values(*next);
      if (there && dot_product(*there, *there) < dot_product(*values, *values)) {
        went = true;
        place = *next;
        values = std::move(there);
        damping = std::max(least_damping, damping / 10);
      } else {
        damping *= 10;
      }
    }
    if (!went) break;
  }
  return place;
}

}  // namespace dini::fitting
