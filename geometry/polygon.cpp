#include "geometry/polygon.h"

#include <cmath>
#include <numeric>

namespace dini {

namespace {

using Flat = std::array<double, 2>;

/// Twice the area of a triangle, positive when it runs counter-clockwise.
double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The corners without the coordinate in which the polygon is thinnest, so that it runs counter-clockwise.
std::vector<Flat> flattened(std::span<const Vector> corners) {
  Vector normal;
  // From the first corner: far from the origin the differences keep their digits.
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal = normal + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  std::vector<Flat> flat;
  for (const Vector& corner : corners) {
    const Vector p = corner - corners[0];
    if (z >= x && z >= y) {
      flat.push_back(normal.z < 0 ? Flat{p.y, p.x} : Flat{p.x, p.y});
    } else if (x >= y) {
      flat.push_back(normal.x < 0 ? Flat{p.z, p.y} : Flat{p.y, p.z});
    } else {
      flat.push_back(normal.y < 0 ? Flat{p.x, p.z} : Flat{p.z, p.x});
    }
  }
  return flat;
}

bool is_convex(const std::vector<Flat>& flat) {
  for (std::size_t i = 0, n = flat.size(); i < n; ++i) {
    if (turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0) return false;
  }
  return true;
}

bool is_inside(const Flat& p, const Flat& a, const Flat& b, const Flat& c) {
  return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

}  // namespace

void PolygonCutter::cut(std::span<const Vector> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto fan = [&](std::span<const std::uint32_t> left) {
    for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
  };
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
    return;
  }
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  const std::vector<Flat> flat = flattened(corners);
  if (corners.size() > most_clipped_corners_ || is_convex(flat)) return fan(left);

  const auto is_ear = [&](std::size_t at) {
    const std::size_t n = left.size();
    const Flat &a = flat[left[(at + n - 1) % n]], &b = flat[left[at]], &c = flat[left[(at + 1) % n]];
    if (!(turn(a, b, c) > 0)) return false;
    for (const std::uint32_t other : left) {
      if (work_left_ == 0) return false;
      --work_left_;
      if (is_inside(flat[other], a, b, c)) return false;
    }
    return true;
  };
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(ear)) ++ear;
    if (ear == left.size()) break;
    const std::size_t n = left.size();
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  fan(left);
}

}  // namespace dini
