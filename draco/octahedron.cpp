#include "draco/octahedron.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace dini {
namespace {

// Halves go up. Without std::floor, which is a call where processors are not assumed to round.
std::int32_t rounded(double value) {
  const double raised = value + 0.5;
  const auto whole = static_cast<std::int32_t>(raised);
  return whole - (raised < static_cast<double>(whole) ? 1 : 0);
}

// By how many quarter turns a point comes to lie where both coordinates are negative, or the second is 0.
int quarter_turns(SquarePoint point) {
  if (point.s == 0 && point.t == 0) return 0;
  if (point.s < 0 && point.t <= 0) return 0;
  if (point.s >= 0 && point.t < 0) return 1;
  return point.s > 0 ? 2 : 3;
}

SquarePoint turned(SquarePoint point, int quarters) {
  switch (quarters) {
    case 1:
      return {point.t, -point.s};
    case 2:
      return {-point.s, -point.t};
    case 3:
      return {-point.t, point.s};
    default:
      return point;
  }
}

}  // namespace

// Every choice is an arithmetic one, so that compilers take several directions at once.
SquarePoint Octahedron::point(const std::array<float, 3>& direction) const {
  const double x = direction[0], y = direction[1], z = direction[2];
  const double length = std::abs(x) + std::abs(y) + std::abs(z);
  const bool is_direction = length > shortest_direction;
  const double scale = 1.0 / (is_direction ? length : 1.0);
  const std::int32_t first = is_direction ? rounded(x * scale * center_) : center_;
  const std::int32_t second = is_direction ? rounded(y * scale * center_) : 0;
  const std::int32_t rest = center_ - std::abs(first) - std::abs(second);
  const std::int32_t excess = std::min(rest, 0);  // rounding up both may go beyond the octahedron
  const std::int32_t kept = second > 0 ? second + excess : second - excess;
  const std::int32_t third = z < 0 ? -std::max(rest, 0) : std::max(rest, 0);
  const std::int32_t side = 2 * center_;
  const std::int32_t far_s = kept < 0 ? std::abs(third) : side - std::abs(third);
  const std::int32_t far_t = third < 0 ? std::abs(kept) : side - std::abs(kept);
  return canonical({first >= 0 ? kept + center_ : far_s, first >= 0 ? third + center_ : far_t});
}

// The corners are one direction, and along each border points mirrored at its middle are.
SquarePoint Octahedron::canonical(SquarePoint point) const {
  const std::int32_t side = 2 * center_;
  const auto [s, t] = point;
  const bool is_corner = (s == 0 || s == side) && (t == 0 || t == side);
  const bool mirror_t = (s == 0 && t > center_) || (s == side && t < center_);
  const bool mirror_s = (t == side && s < center_) || (t == 0 && s > center_);
  return {is_corner ? side : mirror_s ? side - s : s, is_corner ? side : mirror_t ? side - t : t};
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
