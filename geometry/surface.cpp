#include "geometry/surface.h"

#include "geometry/corner.h"
#include "geometry/grid_normals.h"
#include "geometry/grid_samples.h"
#include "geometry/surface_builder.h"
#include "geometry/tiles.h"

namespace dini {

namespace {

/// The normal of a vertex by differences, if they give one.
std::optional<Vector> difference_normal(const GridSamples& samples, const GridNormals& normals,
                                        const SurfaceVertex& vertex) {
  const std::optional<Vector> from = normals.at(vertex.from);
  if (!from || vertex.to == vertex.from) return from;
  const std::optional<Vector> to = samples.torn(vertex.to) ? std::nullopt : normals.at(vertex.to);
  // Far out the samples are sparse; a normal that turned around says nothing.
  if (!to || dot(*from, *to) <= 0) return from;
  return normalized((1 - vertex.way) * *from + vertex.way * *to);
}

/// Sums something per triangle corner into its vertex.
template <class Term>
Zeroed<Vector> corner_sums(const Mesh& mesh, const Cancel& cancel, Term term) {
  Zeroed<Vector> sums(mesh.positions.size());
  CancelEvery steps(cancel);
  for (const auto& triangle : mesh.triangles) {
    if (steps.stopped()) return sums;
    term(triangle, sums);
  }
  return sums;
}

/// Normals by differences where they agree with the triangles, by triangles elsewhere.
Column<Vector> surface_normals(const Mesh& mesh, const GridSamples& samples, const std::vector<SurfaceVertex>& vertices,
                               const Cancel& cancel) {
  const GridNormals by_differences(samples, cancel);
  const Zeroed<Vector> areas = corner_sums(mesh, cancel, [&](const auto& triangle, Zeroed<Vector>& sums) {
    const std::array<Vector, 3> corners = corners_of(mesh, triangle);
    const Vector area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (const std::uint32_t corner : triangle) sums[corner] = sums[corner] + area;
  });
  Column<Vector> normals(vertices.size());
  std::vector<bool> missing(vertices.size());
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < vertices.size() && !steps.stopped(); ++i) {
    const std::optional<Vector> normal = difference_normal(samples, by_differences, vertices[i]);
    missing[i] = !normal || dot(*normal, areas[i]) <= 0;
    if (!missing[i]) normals.set(i, *normal);
  }
  const Zeroed<Vector> fans = corner_sums(mesh, cancel, [&](const auto& triangle, Zeroed<Vector>& sums) {
    if (!missing[triangle[0]] && !missing[triangle[1]] && !missing[triangle[2]]) return;
    const std::array<Vector, 3> weighted = angle_weighted_normals(corners_of(mesh, triangle));
    for (std::size_t k = 0; k < 3; ++k) sums[triangle[k]] = sums[triangle[k]] + weighted[k];
  });
  for (std::size_t i = 0; i < vertices.size() && !steps.stopped(); ++i) {
    if (!missing[i]) continue;
    const Vector fan = normalized(fans[i]);
    normals.set(i, fan == Vector{} ? Vector{0, 0, 1} : fan);
  }
  return normals;
}

}  // namespace

SurfaceResult surface(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel) {
  SurfaceResult result;
  const GridSamples samples(grid, options, cancel);
  if (cancel.stopped()) return result;
  result.first_clipped = samples.first_clipped();
  if (options.at_infinity == AtInfinity::fail && result.first_clipped) return result;
  SurfaceBuilder builder(samples, cancel);
  for_each_tile(samples.rows().steps(), samples.columns().steps(),
                [&](std::size_t row_begin, std::size_t row_end, std::size_t column_begin, std::size_t column_end) {
                  for (std::size_t row = row_begin; row < row_end; ++row) {
                    for (std::size_t column = column_begin; column < column_end; ++column)
                      builder.add_quad(row, column);
                  }
                  builder.end_tile();
                  return !cancel.stopped();
                });
  if (cancel.stopped()) return result;
  result.clipped_quads = builder.clipped_quads();
  result.mesh = builder.take_mesh();
  result.mesh.normals = surface_normals(result.mesh, samples, builder.vertices(), cancel);
  return result;
}

}  // namespace dini
