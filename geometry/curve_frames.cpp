#include "geometry/curve_frames.h"

#include <array>
#include <optional>

#include "geometry/frames.h"
#include "geometry/same_place.h"

namespace dini {

namespace {

/// Below this sine two directions count as the same: round-off of points on a line stays far below.
constexpr double least_bend = 1e-7;

/// The curve without repeated points, and which of its points each one given is.
struct DistinctCurve {
  CurvePiece piece;
  std::vector<std::size_t> number;
};

DistinctCurve distinct(const Polyline& curve, CancelEvery& looks) {
  DistinctCurve found;
  const std::size_t count = curve.points.size();
  found.number.resize(count);
  const SamePlace agree(curve.points, looks);
  std::vector<Vector>& points = found.piece.points;
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) {
    const Vector place = to_vector(curve.points[i]);
    if (points.empty() || !agree(place, points.back())) points.push_back(place);
    found.number[i] = points.size() - 1;
  }
  // The end of a closed curve that comes back to its start is that start.
  while (curve.closed && points.size() > 1 && agree(points.back(), points.front())) {
    for (std::size_t i = count; i-- > 0 && found.number[i] == points.size() - 1;) found.number[i] = 0;
    points.pop_back();
  }
  found.piece.closed = curve.closed && points.size() > 2;
  return found;
}

/// What of `v` is perpendicular to a unit direction, of length 1; nothing where too little of it is.
std::optional<Vector> across(const Vector& v, const Vector& unit) {
  const Vector rest = v - dot(v, unit) * unit;
  if (!(length(rest) > least_bend * length(v))) return std::nullopt;
  return normalized(rest - dot(rest, unit) * unit);
}

/// A direction across the curve, told by its cosine and sine from the steady direction.
struct Turn {
  double cosine = 1, sine = 0;
};

Vector turned(const Frame& steady, const Turn& turn) {
  return turn.cosine * steady.across + turn.sine * cross(steady.tangent, steady.across);
}

Turn turn_to(const Frame& steady, const Vector& direction) {
  return {dot(direction, steady.across), dot(direction, cross(steady.tangent, steady.across))};
}

PlacedFrame frame_of(const Vector& place, const Vector& x, const Vector& z) { return {place, x, cross(z, x), z}; }

/// The direction to the center of curvature at a point, where the curve bends.
std::optional<Vector> bend_at(const CurvePiece& piece, std::size_t i, const Vector& tangent) {
  const std::size_t count = piece.points.size();
  if (count < 3 || (!piece.closed && (i == 0 || i + 1 == count))) return std::nullopt;
  const Vector before = normalized(piece.points[i] - piece.points[(i + count - 1) % count]);
  const Vector after = normalized(piece.points[(i + 1) % count] - piece.points[i]);
  const Vector bend = after - before;
  if (!(length(bend) > least_bend)) return std::nullopt;
  return across(bend, tangent);
}

std::vector<Turn> turns_of_curvature(const CurvePiece& piece, const std::vector<Frame>& steady, const Turn& start,
                                     CancelEvery& looks) {
  const std::size_t count = steady.size();
  std::vector<std::optional<Turn>> found(count);
  std::optional<Turn> known;
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) {
    if (const auto bend = bend_at(piece, i, steady[i].tangent)) found[i] = turn_to(steady[i], *bend);
    if (!known) known = found[i];
  }
  // What is straight goes on as it came; what comes before the first bend, as it will be there.
  Turn last = known.value_or(start);
  std::vector<Turn> turns(count);
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) {
    last = found[i].value_or(last);
    turns[i] = last;
  }
  return turns;
}

std::vector<PlacedFrame> upright_frames(const std::vector<Frame>& steady, const Vector& up, CancelEvery& looks) {
  std::vector<std::optional<Vector>> headings;
  std::optional<Vector> known;
  for (const Frame& frame : steady) {
    if (looks.stopped()) break;
    headings.push_back(across(frame.tangent, up));
    if (!known) known = headings.back();
  }
  Vector heading = known.value_or(any_perpendicular(up));
  std::vector<PlacedFrame> frames;
  for (std::size_t i = 0; i < headings.size() && !looks.stopped(); ++i) {
    heading = headings[i].value_or(heading);
    frames.push_back(frame_of(steady[i].position, heading, up));
  }
  return frames;
}

std::vector<PlacedFrame> frames_of(const CurvePiece& piece, FrameRule rule, const Vector& up, const Cancel& cancel) {
  CancelEvery looks(cancel);
  if (piece.points.empty()) return {};
  if (piece.points.size() == 1) {
    return {frame_of(piece.points.front(), across({1, 0, 0}, up).value_or(any_perpendicular(up)), up)};
  }
  double total = 0;
  const std::vector<Frame> steady = frames_along(piece, total, cancel);
  if (rule == FrameRule::upright) return upright_frames(steady, up, looks);
  const Turn start = turn_to(steady[0], across(up, steady[0].tangent).value_or(steady[0].across));
  std::vector<Turn> turns(steady.size(), start);
  if (rule == FrameRule::curvature) turns = turns_of_curvature(piece, steady, start, looks);
  std::vector<PlacedFrame> frames;
  for (std::size_t i = 0; i < steady.size() && !looks.stopped(); ++i) {
    const Vector z = turned(steady[i], turns[i]);
    frames.push_back(frame_of(steady[i].position, steady[i].tangent, z));
  }
  return frames;
}

}  // namespace

std::vector<PlacedFrame> curve_frames(const Polyline& curve, FrameRule rule, const Vector& up, const Cancel& cancel) {
  CancelEvery looks(cancel);
  const DistinctCurve distinct_curve = distinct(curve, looks);
  const Vector upward = up == Vector{} ? Vector{0, 0, 1} : normalized(up);
  const std::vector<PlacedFrame> frames = frames_of(distinct_curve.piece, rule, upward, cancel);
  std::vector<PlacedFrame> placed;
  placed.reserve(distinct_curve.number.size());
  for (const std::size_t number : distinct_curve.number) {
    if (looks.stopped() || number >= frames.size()) break;
    placed.push_back(frames[number]);
  }
  return placed;
}

}  // namespace dini
