#include "draco/octahedron.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace dini {
namespace {

constexpr double shortest_direction = 1e-6;

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::floor(value + 0.5)); }

// By how many quarter turns a point comes to lie where both coordinates are negative, or the second is 0.
int quarter_turns(SquarePoint point) {
  if (point.s == 0 && point.t == 0) return 0;
  if (point.s < 0 && point.t <= 0) return 0;
  if (point.s >= 0 && point.t < 0) return 1;
  return point.s > 0 ? 2 : 3;
}

SquarePoint turned(SquarePoint point, int quarters) {
  switch (quarters) {
    case 1: return {point.t, -point.s};
    case 2: return {-point.s, -point.t};
    case 3: return {-point.t, point.s};
    default: return point;
  }
}

}  // namespace

SquarePoint Octahedron::point(const std::array<float, 3>& direction) const {
  const auto& [x, y, z] = direction;
  const double length = std::abs(static_cast<double>(x)) + std::abs(static_cast<double>(y)) + std::abs(static_cast<double>(z));
  if (!(length > shortest_direction)) return canonical({center_, center_});
  const double scale = 1.0 / length;
  const std::int32_t first = rounded(x * scale * center_);
  std::int32_t second = rounded(y * scale * center_);
  std::int32_t third = center_ - std::abs(first) - std::abs(second);
  if (third < 0) {
    second += second > 0 ? third : -third;
    third = 0;
  }
  if (z * scale < 0) third = -third;
  if (first >= 0) return canonical({second + center_, third + center_});
  const std::int32_t side = 2 * center_;
  return canonical({second < 0 ? std::abs(third) : side - std::abs(third),
                    third < 0 ? std::abs(second) : side - std::abs(second)});
}

// The corners are one direction, and along each border points mirrored at its middle are.
SquarePoint Octahedron::canonical(SquarePoint point) const {
  const std::int32_t side = 2 * center_;
  const auto [s, t] = point;
  const bool at_end_of_s = s == 0 || s == side;
  const bool at_end_of_t = t == 0 || t == side;
  if (at_end_of_s && at_end_of_t) return {side, side};
  if (s == 0 && t > center_) return {s, side - t};
  if (s == side && t < center_) return {s, side - t};
  if (t == side && s < center_) return {side - s, t};
  if (t == 0 && s > center_) return {side - s, t};
  return point;
}

// At the edge of the inner diamond that is nearest; the far half of the octahedron comes inside.
SquarePoint Octahedron::mirrored(SquarePoint point) const {
  std::int32_t sign_s = point.s > 0 ? 1 : -1;
  std::int32_t sign_t = point.t > 0 ? 1 : -1;
  if (point.s <= 0 && point.t <= 0) sign_s = sign_t = -1;
  if (point.s >= 0 && point.t >= 0) sign_s = sign_t = 1;
  const std::int32_t corner_s = sign_s * center_;
  const std::int32_t corner_t = sign_t * center_;
  std::int32_t s = 2 * point.s - corner_s;
  std::int32_t t = 2 * point.t - corner_t;
  std::swap(s, t);
  if (sign_s == sign_t) {
    s = -s;
    t = -t;
  }
  return {(s + corner_s) / 2, (t + corner_t) / 2};
}

SquarePoint Octahedron::step(SquarePoint predicted, SquarePoint point) const {
  SquarePoint from = {predicted.s - center_, predicted.t - center_};
  SquarePoint to = {point.s - center_, point.t - center_};
  if (std::abs(from.s) + std::abs(from.t) > center_) {
    from = mirrored(from);
    to = mirrored(to);
  }
  const int quarters = quarter_turns(from);
  from = turned(from, quarters);
  to = turned(to, quarters);
  const auto positive = [this](std::int32_t step) { return step < 0 ? step + steps_ : step; };
  return {positive(to.s - from.s), positive(to.t - from.t)};
}

}  // namespace dini
