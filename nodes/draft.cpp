#include "nodes/draft.h"

#include <algorithm>
#include <cmath>

namespace dini {

Segments within_budget(const Context& context, std::int64_t along, std::int64_t across, Segments least) {
  const Segments asked{static_cast<std::size_t>(along), static_cast<std::size_t>(across)};
  const double triangles = 2.0 * static_cast<double>(asked.along) * static_cast<double>(asked.across);
  const std::size_t budget = context.triangle_budget();
  if (budget == 0 || triangles <= static_cast<double>(budget)) return asked;
  const auto bounded = [](std::size_t count, std::size_t lowest, std::size_t most) {
    return std::min(most, std::max(lowest, count));
  };
  const double share = std::sqrt(static_cast<double>(budget) / triangles);
  const auto alike = static_cast<std::size_t>(share * static_cast<double>(asked.along));
  Segments used;
  used.along = bounded(alike, least.along, asked.along);
  used.across = bounded(budget / (2 * used.along), least.across, asked.across);
  used.along = bounded(budget / (2 * used.across), least.along, asked.along);
  return used;
}

TubeSegments tube_within_budget(const Context& context, std::size_t points, bool closed, std::int64_t sides) {
  constexpr std::size_t round_sides = 6, smooth_points = 8, fewest_sides = 3;
  const auto asked = static_cast<std::size_t>(sides);
  const std::size_t budget = context.triangle_budget();
  if (budget == 0 || points == 0 || asked <= budget / (2 * points)) return {points, asked, true};
  const bool small = budget < 2 * round_sides * std::min(points, smooth_points);
  const std::size_t round = std::min(asked, small ? fewest_sides : std::max(round_sides, budget / (2 * points)));
  const bool capped = !small;
  // Between two rings there is one step; caps are as many triangles as another.
  const std::size_t rings = budget / (2 * round) + (capped || closed ? 0 : 1);
  return {std::min(points, std::max<std::size_t>(closed ? 3 : 2, rings)), round, capped};
}

std::size_t fewest_points(const Polyline& curve) {
  if (curve.closed) return 3;
  const std::size_t size = curve.points.size();
  const bool comes_back = size > 2 && curve.points[0] == curve.points[size - 1];
  return comes_back ? 4 : 2;
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
