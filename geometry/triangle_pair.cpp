#include "geometry/triangle_pair.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact_sign.h"

namespace dini {

namespace {

/// On which sides of the plane of one triangle the corners of another are.
std::array<int, 3> sides_of_plane(const PairCorners& plane, const PairCorners& other) {
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = side_of_plane(plane.places[0], plane.places[1], plane.places[2], other.places[k]);
  }
  return sides;
}

bool all_beside(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

/// Signs of which none is below zero, or none above.
bool agree(int a, int b, int c) { return std::min({a, b, c}) >= 0 || std::max({a, b, c}) <= 0; }

/// In one plane, seen along an axis: whether two segments have a point in common.
bool segments_meet(int axis, const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const int ac = turn_seen_along(axis, a, b, c), ad = turn_seen_along(axis, a, b, d);
  const int ca = turn_seen_along(axis, c, d, a), cb = turn_seen_along(axis, c, d, b);
  if (ac != 0 || ad != 0 || ca != 0 || cb != 0) return ac * ad <= 0 && ca * cb <= 0;
  const auto overlap = [](double p, double q, double r, double s) {
    return std::max(std::min(p, q), std::min(r, s)) <= std::min(std::max(p, q), std::max(r, s));
  };
  return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y) && overlap(a.z, b.z, c.z, d.z);
}

/// The same for a segment in the plane of a triangle.
bool meets_in_plane(const PairCorners& triangle, const Vector& p, const Vector& q) {
  const auto& [a, b, c] = triangle.places;
  const int axis = triangle.axis;
  return agree(turn_seen_along(axis, a, b, p), turn_seen_along(axis, b, c, p), turn_seen_along(axis, c, a, p)) ||
         segments_meet(axis, a, b, p, q) || segments_meet(axis, b, c, p, q) || segments_meet(axis, c, a, p, q);
}

/// Whether the edge of `other` from corner k to the next one meets the triangle whose plane has its corners at `sides`.
bool edge_meets(const PairCorners& triangle, const PairCorners& other, const std::array<int, 3>& sides, std::size_t k) {
  const std::size_t next = (k + 1) % 3;
  const Vector &p = other.places[k], &q = other.places[next];
  if (sides[k] * sides[next] > 0) return false;
  if (sides[k] == 0 && sides[next] == 0) return meets_in_plane(triangle, p, q);
  const auto& [a, b, c] = triangle.places;
  return agree(side_of_plane(p, q, a, b), side_of_plane(p, q, b, c), side_of_plane(p, q, c, a));
}

/// Where the corners that both have stand in each of two triangles.
struct CommonCorners {
  std::size_t count = 0;
  std::array<std::size_t, 3> in_a{}, in_b{};
};

CommonCorners common_corners(const PairCorners& a, const PairCorners& b) {
  CommonCorners common;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.vertices[i] != b.vertices[k]) continue;
      common.in_a[common.count] = i;
      common.in_b[common.count++] = k;
    }
  }
  return common;
}

/// Two triangles with a common edge meet beside it when one is folded onto the other.
bool are_folded(const PairCorners& a, const PairCorners& b, const CommonCorners& common) {
  const Vector &p = a.places[common.in_a[0]], &q = a.places[common.in_a[1]];
  const Vector &left = a.places[3 - common.in_a[0] - common.in_a[1]],
               &right = b.places[3 - common.in_b[0] - common.in_b[1]];
  return side_of_plane(p, q, left, right) == 0 &&
         turn_seen_along(a.axis, p, q, left) == turn_seen_along(a.axis, p, q, right);
}

}  // namespace

int axis_of_area(const std::array<Vector, 3>& places) {
  const Vector normal = cross(places[1] - places[0], places[2] - places[0]);
  const std::array<double, 3> sizes = {std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
    return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
  });
  for (const int axis : axes) {
    if (turn_seen_along(axis, places[0], places[1], places[2]) != 0) return axis;
  }
  return -1;
}

bool triangles_meet(const PairCorners& a, const PairCorners& b) {
  const CommonCorners common = common_corners(a, b);
  if (common.count == 3) return true;
  if (common.count == 2) return are_folded(a, b, common);
  const std::array<int, 3> b_beside_a = sides_of_plane(a, b);
  if (all_beside(b_beside_a)) return false;
  if (common.count == 1) {
    // What both have begins at the common corner, and leaves one of them through the edge that is opposite to it.
    const std::size_t in_a = (common.in_a[0] + 1) % 3, in_b = (common.in_b[0] + 1) % 3;
    if (b_beside_a[in_b] * b_beside_a[(in_b + 1) % 3] > 0) return false;
    return edge_meets(a, b, b_beside_a, in_b) || edge_meets(b, a, sides_of_plane(b, a), in_a);
  }
  const std::array<int, 3> a_beside_b = sides_of_plane(b, a);
  if (all_beside(a_beside_b)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (edge_meets(a, b, b_beside_a, k) || edge_meets(b, a, a_beside_b, k)) return true;
  }
  return false;
}

}  // namespace dini
