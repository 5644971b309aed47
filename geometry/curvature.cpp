#include "geometry/curvature.h"

#include <cmath>

#include "geometry/corner.h"
#include "geometry/in_order.h"
#include "geometry/normals.h"

namespace dini {

namespace {

/// A symmetric tensor of space.
struct Tensor {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  Vector times(const Vector& v) const {
    return {xx * v.x + xy * v.y + zx * v.z, xy * v.x + yy * v.y + yz * v.z, zx * v.x + yz * v.y + zz * v.z};
  }
  double trace() const { return xx + yy + zz; }
  double squared_norm() const { return xx * xx + yy * yy + zz * zz + 2 * (xy * xy + yz * yz + zx * zx); }

  void add(double weight, const Tensor& other) {
    xx += weight * other.xx;
    yy += weight * other.yy;
    zz += weight * other.zz;
    xy += weight * other.xy;
    yz += weight * other.yz;
    zx += weight * other.zx;
  }
};

/// l tt + m (tb + bt) + n bb.
Tensor tensor_in_plane(const Vector& t, const Vector& b, double l, double m, double n) {
  const auto entry = [&](double ti, double tj, double bi, double bj) {
    return l * ti * tj + m * (ti * bj + bi * tj) + n * bi * bj;
  };
  return {entry(t.x, t.x, b.x, b.x), entry(t.y, t.y, b.y, b.y), entry(t.z, t.z, b.z, b.z),
          entry(t.x, t.y, b.x, b.y), entry(t.y, t.z, b.y, b.z), entry(t.z, t.x, b.z, b.x)};
}

/// The tensor that takes each edge to the turn of the normals along it, as well as least squares can: edge (u, v) and
/// turn (du, dv) in the plane of the triangle ask for u l + v m = du and u m + v n = dv. Nothing for a triangle without
/// area.
bool shape_of_triangle(const std::array<Vector, 3>& corners, const std::array<Vector, 3>& normals, Tensor& shape) {
  const Vector t = quick_unit(corners[1] - corners[0]);
  const Vector n = quick_unit(cross(t, corners[2] - corners[0]));
  if (t == Vector{} || n == Vector{}) return false;
  const Vector b = cross(n, t);
  double uu = 0, uv = 0, vv = 0, first = 0, middle = 0, last = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector edge = corners[(k + 1) % 3] - corners[k];
    const Vector turn = normals[(k + 1) % 3] - normals[k];
    const double u = dot(edge, t), v = dot(edge, b), du = dot(turn, t), dv = dot(turn, b);
    uu += u * u;
    uv += u * v;
    vv += v * v;
    first += u * du;
    middle += v * du + u * dv;
    last += v * dv;
  }
  // Normal equations [uu uv 0; uv uu+vv uv; 0 uv vv] (l m n) = (first middle last).
  const double pivot = (uu + vv) - uv * uv / uu - uv * uv / vv;
  if (!(uu > 0) || !(vv > 0) || !(pivot > 0)) return false;
  const double m = (middle - uv * first / uu - uv * last / vv) / pivot;
  shape = tensor_in_plane(t, b, (first - uv * m) / uu, m, (last - uv * m) / vv);
  return true;
}

/// What a triangle adds to its corners.
struct Share {
  Tensor shape;
  double area = 0;
  bool known = false;
};

Share share_of_triangle(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, const Column<Vector>& normals) {
  const std::array<Vector, 3> corners = corners_of(mesh, triangle);
  Share share;
  share.known =
      shape_of_triangle(corners, {normals[triangle[0]], normals[triangle[1]], normals[triangle[2]]}, share.shape);
  if (share.known) share.area = 0.5 * length(cross(corners[1] - corners[0], corners[2] - corners[0]));
  return share;
}

}  // namespace

Curvatures estimate_curvatures(const Mesh& mesh, const Cancel& cancel) {
  const std::size_t size = mesh.positions.size();
  Curvatures result{Zeroed<double>(size), Zeroed<double>(size)};
  const Column<Vector> computed = mesh.normals.empty() ? smooth_normals(mesh, cancel) : Column<Vector>();
  const Column<Vector>& normals = mesh.normals.empty() ? computed : *mesh.normals;
  Zeroed<Tensor> shapes(size);
  Zeroed<double> areas(size);
  const auto& triangles = *mesh.triangles;
  compute_in_order<Share>(
      cancel, triangles.size(), [&](std::size_t i) { return share_of_triangle(mesh, triangles[i], normals); },
      [&](std::size_t i, const Share& share) {
        if (!share.known) return;
        for (const std::uint32_t vertex : triangles[i]) {
          shapes[vertex].add(share.area, share.shape);
          areas[vertex] += share.area;
        }
      });
  if (cancel.stopped()) return result;
  const auto finish = [&](std::size_t i) {
    if (!(areas[i] > 0)) return;
    // Seen along the normal of the vertex: P S P with P = 1 - n n.
    const Vector normal = normals[i];
    const Vector tilted = shapes[i].times(normal);
    const double height = dot(tilted, normal);
    const double trace = (shapes[i].trace() - height) / areas[i];
    const double square =
        (shapes[i].squared_norm() - 2 * squared_length(tilted) + height * height) / (areas[i] * areas[i]);
    result.mean[i] = 0.5 * trace;
    result.gauss[i] = 0.5 * (trace * trace - square);
  };
  for_chunks(cancel, size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) finish(i);
  });
  return result;
}

}  // namespace dini
