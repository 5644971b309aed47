#include "geometry/frames.h"

#include "geometry/angle.h"

namespace dini {

namespace {

/// Ends follow the circle of their neighbors up to this bend (30 degrees); a sharper one is a corner.
constexpr double smooth_bend = 0.8660254037844386;

/// The tangent at the middle one of three points: that of the circle through them.
Vector circle_tangent(const Vector& before, const Vector& after) {
  const double ratio = length(after) / length(before);
  const Vector tangent = normalized(ratio * before + (1 / ratio) * after);
  return tangent == Vector{} ? normalized(after) : tangent;
}

/// The tangent at an open end with the step `end` to its neighbor, whose tangent is `inner` and next step `next`.
Vector end_tangent(const Vector& end, const Vector& inner, const Vector& next) {
  const Vector unit = normalized(end);
  return dot(unit, normalized(next)) > smooth_bend ? normalized(2 * dot(unit, inner) * unit - inner) : unit;
}

std::vector<Vector> tangents_of(const CurvePiece& piece, const std::vector<Vector>& steps, CancelEvery& looks) {
  const std::size_t count = piece.points.size();
  std::vector<Vector> tangents(count, normalized(steps[0]));
  const std::size_t first = piece.closed ? 0 : 1;
  const std::size_t last = piece.closed ? count : count - 1;
  for (std::size_t i = first; i < last && !looks.stopped(); ++i) {
    tangents[i] = circle_tangent(steps[(i + count - 1) % count], steps[i]);
  }
  if (!piece.closed && count > 2) {
    tangents[0] = end_tangent(steps[0], tangents[1], steps[1]);
    tangents[count - 1] = end_tangent(steps[count - 2], tangents[count - 2], steps[count - 3]);
  }
  return tangents;
}

Vector reflected(const Vector& v, const Vector& mirror) {
  const double square = squared_length(mirror);
  return square > 0 ? v - (2 * dot(mirror, v) / square) * mirror : v;
}

/// The direction `across` carried over a step to the next tangent.
Vector carried(const Vector& across, const Vector& tangent, const Vector& step, const Vector& next_tangent) {
  const Vector direction = normalized(step);
  const Vector mirror = next_tangent - reflected(tangent, direction);
  const Vector moved = reflected(reflected(across, direction), mirror);
  const Vector upright = normalized(moved - dot(moved, next_tangent) * next_tangent);
  return upright == Vector{} ? any_perpendicular(next_tangent) : upright;
}

/// The angle in turns about `axis` that takes `from` to `to`, both perpendicular to it.
double turn_between(const Vector& from, const Vector& to, const Vector& axis) {
  const double sine = dot(cross(from, to), axis);
  return std::copysign(angle_of(dot(from, to), std::abs(sine)), sine) / (2 * pi);
}

}  // namespace

std::vector<Frame> frames_along(const CurvePiece& piece, double& total, const Cancel& cancel) {
  const std::size_t count = piece.points.size();
  CancelEvery looks(cancel);
  std::vector<Vector> steps(count);
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) {
    steps[i] = piece.points[(i + 1) % count] - piece.points[i];
  }
  const std::vector<Vector> tangents = tangents_of(piece, steps, looks);
  std::vector<Frame> frames(count);
  frames[0] = {piece.points[0], tangents[0], any_perpendicular(tangents[0]), 0};
  for (std::size_t i = 1; i < count && !looks.stopped(); ++i) {
    frames[i] = {piece.points[i], tangents[i],
                 carried(frames[i - 1].across, tangents[i - 1], steps[i - 1], tangents[i]),
                 frames[i - 1].along + length(steps[i - 1])};
  }
  total = frames.back().along;
  if (!piece.closed) return frames;
  total += length(steps.back());
  const Vector returned = carried(frames.back().across, tangents.back(), steps.back(), tangents[0]);
  const double twist = turn_between(returned, frames[0].across, tangents[0]);
  for (Frame& frame : frames) {
    if (looks.stopped()) break;
    const SineCosine turn = sine_cosine(twist * frame.along / total);
    frame.across = turn.cosine * frame.across + turn.sine * cross(frame.tangent, frame.across);
  }
  return frames;
}

}  // namespace dini
