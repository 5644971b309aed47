#include "nodes/draft.h"

#include <algorithm>
#include <cmath>

namespace dini {

Segments within_budget(const Context& context, std::int64_t along, std::int64_t across, Segments least) {
  const Segments asked{static_cast<std::size_t>(along), static_cast<std::size_t>(across)};
  const double triangles = 2.0 * static_cast<double>(asked.along) * static_cast<double>(asked.across);
  const auto budget = static_cast<double>(context.triangle_budget());
  if (budget == 0 || triangles <= budget) return asked;
  const double share = std::sqrt(budget / triangles);
  const auto scaled = [share](std::size_t count, std::size_t lowest) {
    return std::min(count, std::max(lowest, static_cast<std::size_t>(share * static_cast<double>(count))));
  };
  return {scaled(asked.along, least.along), scaled(asked.across, least.across)};
}

Segments tube_within_budget(const Context& context, std::size_t points, std::int64_t sides) {
  constexpr std::size_t fewest_sides = 6;
  constexpr std::size_t fewest_points = 8;
  const auto asked = static_cast<std::size_t>(sides);
  const std::size_t budget = context.triangle_budget();
  if (budget == 0 || points == 0 || asked <= budget / (2 * points)) return {points, asked};
  const std::size_t round = std::min(asked, std::max(fewest_sides, budget / (2 * points)));
  return {std::min(points, std::max(fewest_points, budget / (2 * round))), round};
}

Polyline thinned(const Polyline& curve, std::size_t points) {
  const std::size_t size = curve.points.size();
  if (points >= size || points < 2) return curve;
  Polyline result{Column<Point>(points), curve.closed};
  for (std::size_t i = 0; i < points; ++i) {
    result.points.set(i, curve.points[curve.closed ? i * size / points : i * (size - 1) / (points - 1)]);
  }
  return result;
}

}  // namespace dini
