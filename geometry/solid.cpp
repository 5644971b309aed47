#include "geometry/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/bounding_box.h"
#include "geometry/compensated_sum.h"
#include "geometry/corner.h"
#include "geometry/extremes.h"
#include "geometry/in_order.h"
#include "geometry/mesh_tree.h"

namespace dini {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Sets of vertices that are joined, by the lowest of each.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t lowest(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }
  /// Whether two sets became one.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = lowest(a);
    b = lowest(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Integrals over a solid: of 1, of the coordinates, of their squares, and of y z, z x and x y.
using Moments = std::array<double, 10>;

/// Over the tetrahedron of a triangle and the origin, with the sign of its volume.
Moments moments_of(const Vector& a, const Vector& b, const Vector& c) {
  const Vector sum = a + b + c;
  const double volume = dot(a, cross(b, c));
  const auto second = [&](double Vector::*i, double Vector::*k) {
    return volume / 120 * (a.*i * a.*k + b.*i * b.*k + c.*i * c.*k + sum.*i * sum.*k);
  };
  return {volume / 6,
          volume / 24 * sum.x,
          volume / 24 * sum.y,
          volume / 24 * sum.z,
          second(&Vector::x, &Vector::x),
          second(&Vector::y, &Vector::y),
          second(&Vector::z, &Vector::z),
          second(&Vector::y, &Vector::z),
          second(&Vector::z, &Vector::x),
          second(&Vector::x, &Vector::y)};
}

/// How many times its direction a ray goes until it leaves through a triangle; infinite where it does not. A hair
/// beside the triangle counts, so that no ray slips through between two.
double way_out(const std::array<Vector, 3>& corners, const Vector& origin, const Vector& direction) {
  constexpr double hair = 1e-9;
  const Vector u = corners[1] - corners[0], v = corners[2] - corners[0];
  const Vector normal = cross(u, v);
  const double speed = dot(normal, direction), size = std::sqrt(squared_length(normal));
  if (!(speed > 0.5 * size)) return infinite;
  const Vector away = corners[0] - origin;
  const Vector aside = cross(direction, away);
  const double s = -dot(v, aside) / speed, t = dot(u, aside) / speed;
  if (!(s >= -hair && t >= -hair && s + t <= 1 + hair)) return infinite;
  const double way = dot(normal, away) / speed;
  return way > 0 ? way : infinite;
}

}  // namespace

Soundness soundness_of(const WeldedMesh& mesh, const Cancel& cancel) {
  Soundness result;
  if (mesh.triangles.empty()) return result;
  const MeshSides sides = sides_of(mesh.triangles, mesh.positions.size(), cancel);
  result.watertight = sides.borders.empty() && sides.faults.empty();
  JoinedSets pieces(mesh.positions.size()), rims(mesh.positions.size());
  result.components = mesh.positions.size();
  CancelEvery steps(cancel);
  for (const auto& [a, b, c] : mesh.triangles) {
    if (steps.stopped()) return result;
    if (pieces.join(a, b)) --result.components;
    if (pieces.join(b, c)) --result.components;
  }
  std::vector<bool> on_rim(mesh.positions.size());
  for (const std::uint32_t side : sides.borders) {
    if (steps.stopped()) return result;
    const std::uint32_t p = start_of(mesh.triangles, side), q = end_of(mesh.triangles, side);
    for (const std::uint32_t vertex : {p, q}) {
      if (!on_rim[vertex]) ++result.borders;
      on_rim[vertex] = true;
    }
    if (rims.join(p, q)) --result.borders;
  }
  return result;
}

MassProperties mass_properties(const WeldedMesh& mesh, const Cancel& cancel) {
  if (mesh.triangles.empty() || cancel.stopped()) return {};
  BoundingBox bounds;
  for (const Vector& position : mesh.positions) bounds.add(position);
  const Vector middle = bounds.middle();
  std::array<CompensatedSum, 10> sums, sizes;
  compute_in_order<Moments>(
      cancel, mesh.triangles.size(),
      [&](std::size_t i) {
        const auto& [a, b, c] = mesh.triangles[i];
        return moments_of(mesh.positions[a] - middle, mesh.positions[b] - middle, mesh.positions[c] - middle);
      },
      [&](std::size_t, const Moments& moments) {
        for (std::size_t k = 0; k < moments.size(); ++k) sums[k].add(moments[k]);
        sizes[0].add(std::abs(moments[0]));
      });
  // What is left of volumes that cancel is round-off.
  if (!(std::abs(sums[0].value()) > 1e-12 * sizes[0].value())) return {middle, {}, {}};
  const double volume = sums[0].value();
  const Vector center = Vector{sums[1].value(), sums[2].value(), sums[3].value()} / volume;
  const double sign = volume > 0 ? 1 : -1;
  const auto about_center = [&](std::size_t k, double product) { return sign * (sums[k].value() - volume * product); };
  const double xx = about_center(4, center.x * center.x), yy = about_center(5, center.y * center.y),
               zz = about_center(6, center.z * center.z);
  return {middle + center,
          {yy + zz, zz + xx, xx + yy},
          {about_center(7, center.y * center.z), about_center(8, center.z * center.x),
           about_center(9, center.x * center.y)}};
}

double least_thickness(const WeldedMesh& mesh, const Cancel& cancel) {
  if (mesh.triangles.empty() || cancel.stopped()) return 0;
  constexpr std::size_t rays_at_once = 256;
  const MeshTree tree(mesh.positions, mesh.triangles, cancel);
  std::atomic<double> least = infinite;
  const auto corners = [&](std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return std::array<Vector, 3>{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
  };
  for_chunks(cancel, mesh.triangles.size(), rays_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::array<Vector, 3> own = corners(i);
      const Vector inward = -tree.normal(i);
      if (inward == Vector{}) continue;
      const Vector origin = (own[0] + own[1] + own[2]) / 3;
      double found = least.load(std::memory_order_relaxed);
      tree.visit_along(origin, inward, found, [&](std::uint32_t triangle, double most) {
        if (triangle != i) found = std::min(found, way_out(corners(triangle), origin, inward));
        return std::min(most, found);
      });
      lower_to(least, found);
    }
  });
  return std::isfinite(least.load()) ? least.load() : 0;
}

}  // namespace dini
