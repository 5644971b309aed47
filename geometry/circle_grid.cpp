#include "geometry/circle_grid.h"

#include <algorithm>

#include "algebra/elementary.h"

namespace dini {

namespace {

/// Where the sampling of a circle starts, and the frame there: `along` the circle, `inward` to its center.
struct Start {
  Vector at;
  Vector along;
  Vector inward;
};

Start start_towards(const CircleCoordinates& circle, const Vector& outward) {
  const Vector unit = normalized(outward - dot(outward, circle.normal) * circle.normal);
  const Vector direction = unit == Vector{} ? any_perpendicular(circle.normal) : unit;
  return {to_vector(circle.center) + circle.radius * direction, cross(circle.normal, direction), -direction};
}

Start first_start(const CircleCoordinates& circle) {
  if (circle.line) return {to_vector(circle.point), circle.direction, {}};
  return start_towards(circle, any_perpendicular(circle.normal));
}

/// The start of `circle` that continues `previous`.
Start next_start(const CircleCoordinates& circle, const Start& previous) {
  if (circle.line) {
    const Vector from = to_vector(circle.point);
    return {from + dot(previous.at - from, circle.direction) * circle.direction, circle.direction, {}};
  }
  const Vector outward = previous.inward == Vector{} ? previous.at - to_vector(circle.center) : -previous.inward;
  const Start same = start_towards(circle, outward);
  const Start opposite = start_towards(circle, -outward);
  return squared_length(opposite.at - previous.at) < squared_length(same.at - previous.at) ? opposite : same;
}

/// The start turned by `angle` about the circle's normal.
Start turned(const CircleCoordinates& circle, const Start& start, double angle) {
  if (circle.line) return start;
  const elementary::SineCosine turn = elementary::sincos(angle);
  return start_towards(circle, -turn.cosine * start.inward + turn.sine * start.along);
}

/// The angle about the normal from one start of a circle to another.
double angle_between(const Start& from, const Start& to) {
  return elementary::atan2(dot(from.along, -to.inward), dot(from.inward, to.inward));
}

/// The point at `turn` of the half circle parameter: stereographic about the start with scale `width`, which is plain
/// uniform sampling when the width is the diameter.
Point point_from(const CircleCoordinates& circle, const Start& start, double turn, double width) {
  if (!circle.line && circle.radius == 0) return circle.center;
  const elementary::SineCosine half = elementary::sincos_turns(turn / 2);
  const double across = width * half.sine;
  const double bend = circle.line ? 0 : across / (2 * circle.radius);
  const double weight = half.cosine * half.cosine + bend * bend;
  if (weight == 0) return Point::at_infinity();
  return to_point(start.at + (across * half.cosine * start.along + across * bend * start.inward) / weight);
}

bool all_circles(const std::vector<std::optional<CircleCoordinates>>& circles) {
  return std::all_of(circles.begin(), circles.end(), [](const auto& circle) { return circle && !circle->line; });
}

}  // namespace

Column<Point> sample_circle_row(const std::vector<std::optional<CircleCoordinates>>& circles, std::size_t segments,
                                bool closed_family, double widest, const Cancel& cancel) {
  std::vector<Start> starts(circles.size());
  const Start* previous = nullptr;
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < circles.size() && !steps.stopped(); ++i) {
    if (!circles[i]) continue;
    starts[i] = previous == nullptr ? first_start(*circles[i]) : next_start(*circles[i], *previous);
    previous = &starts[i];
  }
  double excess = 0;
  if (closed_family && circles.size() > 2 && all_circles(circles)) {
    excess = angle_between(starts.front(), next_start(*circles.front(), starts.back()));
  }
  Column<Point> points(circles.size() * segments);
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (!circles[i]) {
      for (std::size_t j = 0; j < segments; ++j) points.set(i * segments + j, Point::at_infinity());
      continue;
    }
    const double share = excess * static_cast<double>(i) / static_cast<double>(circles.size());
    const Start start = share == 0 ? starts[i] : turned(*circles[i], starts[i], -share);
    const double width = circles[i]->line ? 2 * widest : 2 * std::min(circles[i]->radius, widest);
    for (std::size_t j = 0; j < segments && !steps.stopped(); ++j) {
      points.set(i * segments + j,
                 point_from(*circles[i], start, static_cast<double>(j) / static_cast<double>(segments), width));
    }
  }
  return points;
}

}  // namespace dini
