#include "service/control_lines.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/curve_pieces.h"

namespace dini {

namespace {

constexpr std::size_t round_segments = 96;
constexpr double shortest_arrow = 0.05;  ///< of the size of the frame
constexpr double longest_head = 0.15;    ///< of the size of the frame
constexpr double mark_size = 0.04;       ///< of the size of the frame

Vector on_circle(const Vector& center, const Vector& start, const Vector& side, double radius, double turns) {
  const SineCosine at = sine_cosine(turns);
  return center + (radius * at.cosine) * start + (radius * at.sine) * side;
}

}  // namespace

void ControlLines::strip(const std::vector<Vector>& points, bool closed) {
  Polyline line{Column<Point>(points.size()), closed};
  for (std::size_t i = 0; i < points.size(); ++i) line.points.set(i, to_point(points[i]));
  curve(line);
}

void ControlLines::curve(const Polyline& curve) {
  for (const CurvePiece& piece : curve_pieces(curve, frame_.reach, cancel_)) {
    Polyline line{Column<Point>(piece.points.size()), piece.closed};
    for (std::size_t i = 0; i < piece.points.size(); ++i) line.points.set(i, to_point(piece.points[i]));
    lines_.push_back(std::move(line));
  }
}

void ControlLines::segment(const Vector& from, const Vector& to) { strip({from, to}); }

void ControlLines::arrow(const Vector& from, const Vector& by) {
  const Vector along = normalized(by);
  if (along == Vector{}) return;
  const double size = std::clamp(length(by), shortest_arrow * frame_.size, frame_.reach);
  const Vector tip = from + size * along;
  segment(from, tip);
  arrow_head(tip, along, std::min(0.25 * size, longest_head * frame_.size));
}

void ControlLines::arrow_head(const Vector& tip, const Vector& along, double size) {
  const Vector across = any_perpendicular(along);
  for (const Vector& side : {across, cross(along, across)}) {
    const Vector back = tip - size * along;
    strip({back + (0.4 * size) * side, tip, back - (0.4 * size) * side});
  }
}

void ControlLines::cross_mark(const Vector& at) {
  const double half = mark_size * frame_.size;
  for (const Vector& axis : {Vector{half, 0, 0}, Vector{0, half, 0}, Vector{0, 0, half}}) segment(at - axis, at + axis);
}

void ControlLines::line(const CircleCoordinates& line) {
  // The chord of the sphere of reach; a line far off has none.
  const Vector place = to_vector(line.point);
  const double distance = length(place);
  if (!(distance < frame_.reach)) return;
  const double half = (1 - 1e-9) * std::sqrt((frame_.reach - distance) * (frame_.reach + distance));
  segment(place - half * line.direction, place + half * line.direction);
}

void ControlLines::round(const CircleCoordinates& circle, bool dashed) {
  if (circle.line) return line(circle);
  if (circle.radius == 0) return cross_mark(to_vector(circle.center));
  const Vector center = to_vector(circle.center);
  // Of a circle much wider than the frame only the near part is drawn, with all its points.
  const Vector inward = frame_.center - center;
  const Vector near = normalized(inward - dot(inward, circle.normal) * circle.normal);
  const Vector start = near == Vector{} ? any_perpendicular(circle.normal) : near;
  const Vector side = cross(circle.normal, start);
  const double part = std::min(1.0, 2 * frame_.reach / circle.radius);
  std::vector<Vector> points;
  for (std::size_t i = 0; i <= round_segments; ++i) {
    const double place = static_cast<double>(i) / round_segments - 0.5;
    points.push_back(on_circle(center, start, side, circle.radius, part * place));
  }
  if (!dashed) {
    const bool closed = part == 1.0;
    if (closed) points.pop_back();
    return strip(points, closed);
  }
  for (std::size_t i = 0; i < round_segments; i += 2) segment(points[i], points[i + 1]);
}

void ControlLines::turn_mark(const Vector& center, const Vector& normal, double radius) {
  constexpr std::size_t segments = 36;
  constexpr double turns = 0.75;
  const Vector start = any_perpendicular(normal), side = cross(normal, start);
  std::vector<Vector> points;
  for (std::size_t i = 0; i <= segments; ++i) {
    points.push_back(on_circle(center, start, side, radius, turns * static_cast<double>(i) / segments));
  }
  strip(points);
  // At three quarters the circle runs along its start.
  arrow_head(points.back(), start, 0.5 * radius);
}

}  // namespace dini
