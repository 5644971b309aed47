#include "geometry/displacement.h"

#include <algorithm>
#include <cmath>

#include "geometry/corner.h"
#include "geometry/in_order.h"

namespace dini {

namespace {

/// What the triangles around each position say about its normal.
struct Around {
  Vector sum;         ///< of normals times angles
  double angles = 0;  ///< of the triangles that have an area
  Vector first;       ///< the normal of the first of them
};

std::vector<Around> look_around(const WeldedMesh& welded, const Cancel& cancel) {
  std::vector<Around> around(welded.positions.size());
  compute_in_order<std::array<Vector, 3>>(
      cancel, welded.triangles.size(),
      [&](std::size_t i) {
        const auto& [a, b, c] = welded.triangles[i];
        return angle_weighted_normals({welded.positions[a], welded.positions[b], welded.positions[c]});
      },
      [&](std::size_t i, const std::array<Vector, 3>& weighted) {
        for (std::size_t k = 0; k < 3; ++k) {
          Around& at = around[welded.triangles[i][k]];
          const double angle = std::sqrt(squared_length(weighted[k]));
          at.sum = at.sum + weighted[k];
          at.angles += angle;
          if (at.first == Vector{}) at.first = quick_unit(weighted[k]);
        }
      });
  return around;
}

/// The normals of the mesh by position; nothing where two at one position differ, or one does not face as its
/// triangles.
std::vector<Vector> agreed_normals(const Mesh& mesh, const WeldedMesh& welded, const std::vector<Around>& around,
                                   CancelEvery& steps) {
  if (mesh.normals.empty()) return {};
  constexpr double alike = 1e-6, faces = 0.2;
  std::vector<Vector> normals(welded.positions.size());
  for (std::size_t i = 0; i < welded.vertex_of.size(); ++i) {
    if (steps.stopped()) return {};
    if (welded.vertex_of[i] == none_of_them) continue;
    Vector& known = normals[welded.vertex_of[i]];
    const Vector normal = mesh.normals[i];
    if (known == Vector{}) known = normal;
    if (squared_length(known - normal) > alike * alike) return {};
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (steps.stopped() || dot(normals[i], around[i].sum) < faces * around[i].angles) return {};
  }
  return normals;
}

/// The mean direction of the triangles at a position.
Vector mean_normal(const Around& around) {
  const double sum = std::sqrt(squared_length(around.sum));
  if (sum > 1e-9 * around.angles) return around.sum / sum;
  return around.first == Vector{} ? Vector{0, 0, 1} : around.first;
}

/// How far along a normal planes meet that move by 1; on a smooth surface 1 where the triangles make
/// less of a corner than `even_fit` says, and towards `corner_fit` more and more of that.
double reach_along(const Vector& normal, const Around& around, bool smooth) {
  constexpr double corner_fit = 0.9, even_fit = 0.95;
  const double fit = around.angles > 0 ? dot(normal, around.sum) / around.angles : 1;
  const double reach = fit * longest_miter > 1 ? 1 / fit : longest_miter;
  if (!smooth) return reach;
  return 1 + (reach - 1) * std::clamp((even_fit - fit) / (even_fit - corner_fit), 0.0, 1.0);
}

}  // namespace

Displacements displacements(const Mesh& mesh, const WeldedMesh& welded, const Cancel& cancel) {
  const std::vector<Around> around = look_around(welded, cancel);
  CancelEvery steps(cancel);
  Displacements result{agreed_normals(mesh, welded, around, steps)};
  result.smooth = !result.directions.empty();
  result.directions.resize(around.size());
  for (std::size_t i = 0; i < around.size() && !steps.stopped(); ++i) {
    const Vector normal = result.smooth ? result.directions[i] : mean_normal(around[i]);
    result.directions[i] = reach_along(normal, around[i], result.smooth) * normal;
  }
  return result;
}

Mesh offset(const Mesh& mesh, double distance, const Cancel& cancel) {
  const WeldedMesh surface = welded(mesh, cancel);
  const Displacements found = displacements(mesh, surface, cancel);
  Mesh moved = mesh;
  Column<Point>& positions = moved.positions.edit();
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < surface.vertex_of.size() && !steps.stopped(); ++i) {
    const std::uint32_t vertex = surface.vertex_of[i];
    if (vertex == none_of_them) continue;
    positions.set(i, to_point(surface.positions[vertex] + distance * found.directions[vertex]));
  }
  return moved;
}

}  // namespace dini
