#include "geometry/surface_normals.h"

#include <algorithm>
#include <cstring>

#include "geometry/chunks.h"
#include "geometry/corner.h"

namespace dini {

namespace {

/// A vertex whose normal is in doubt: a sample, or the way between two.
struct DoubtfulVertex {
  std::size_t number;
  std::size_t from, to;
  double way;
};

/// The normal of a vertex by differences, if they give one.
std::optional<Vector> difference_normal(const GridSamples& samples, const GridNormals& normals,
                                        const DoubtfulVertex& vertex) {
  const std::optional<Vector> from = normals.at(vertex.from);
  if (!from || vertex.to == vertex.from) return from;
  const std::optional<Vector> to = samples.torn(vertex.to) ? std::nullopt : normals.at(vertex.to);
  // Far out the samples are sparse; a normal that turned around says nothing.
  if (!to || dot(*from, *to) <= 0) return from;
  return normalized((1 - vertex.way) * *from + vertex.way * *to);
}

bool touches_doubt(const GridSamples& samples, const SurfaceTile& tile, const Zeroed<std::uint8_t>& doubtful) {
  if (tile.irregular && !tile.irregular->cuts.empty()) return true;
  const std::size_t columns = samples.columns().size();
  const std::size_t end = std::min(tile.block.column_end + 1, columns);
  for (std::size_t row = tile.block.row_begin; row <= tile.block.row_end; ++row) {
    const std::uint8_t* const line = doubtful.data() + samples.index(row % samples.rows().size(), 0);
    if (std::memchr(line + tile.block.column_begin, 1, end - tile.block.column_begin) != nullptr) return true;
    if (tile.block.column_end == columns && line[0] != 0) return true;
  }
  return false;
}

/// Calls body(triangle) for the triangles of the tiles around vertices in doubt, in their order.
template <class Body>
void for_each_triangle(const Mesh& mesh, const std::vector<std::pair<std::size_t, std::size_t>>& runs,
                       const Cancel& cancel, Body body) {
  CancelEvery steps(cancel);
  for (const auto& [begin, end] : runs) {
    for (std::size_t i = begin; i < end && !steps.stopped(); ++i) body(mesh.triangles[i]);
  }
}

}  // namespace

void settle_normals(const GridSamples& samples, const GridNormals& by_differences,
                    const std::vector<SurfaceTile>& tiles, const SurfaceVertices& vertices,
                    const Zeroed<std::uint8_t>& doubtful, Mesh& mesh, const Cancel& cancel) {
  std::vector<DoubtfulVertex> doubts;
  const std::uint8_t* const bytes = doubtful.data();
  for (const std::uint8_t* at = bytes; at < doubtful.end(); ++at) {
    at = static_cast<const std::uint8_t*>(std::memchr(at, 1, static_cast<std::size_t>(doubtful.end() - at)));
    if (at == nullptr || cancel.stopped()) break;
    const auto sample = static_cast<std::size_t>(at - bytes);
    if (vertices.uses(sample)) doubts.push_back({vertices.of_sample(sample), sample, sample, 0});
  }
  for (const CutVertex& cut : vertices.cuts()) {
    doubts.push_back({vertices.sample_count() + (&cut - vertices.cuts().data()), cut.from, cut.to, cut.way});
  }
  if (doubts.empty()) return;

  std::vector<std::pair<std::size_t, std::size_t>> runs;
  std::size_t begin = 0;
  for (const SurfaceTile& tile : tiles) {
    const std::size_t end = begin + tile.triangles();
    if (touches_doubt(samples, tile, doubtful)) runs.push_back({begin, end});
    begin = end;
  }
  Zeroed<std::uint8_t> wanted(vertices.size());
  for (const DoubtfulVertex& doubt : doubts) wanted[doubt.number] = 1;
  Zeroed<Vector> areas(vertices.size());
  for_each_triangle(mesh, runs, cancel, [&](const std::array<std::uint32_t, 3>& triangle) {
    if ((wanted[triangle[0]] | wanted[triangle[1]] | wanted[triangle[2]]) == 0) return;
    const std::array<Vector, 3> corners = corners_of(mesh, triangle);
    const Vector area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (const std::uint32_t corner : triangle) areas[corner] = areas[corner] + area;
  });
  Column<Vector>& settled = mesh.normals.edit();
  for_chunks(cancel, doubts.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t vertex = doubts[i].number;
      const std::optional<Vector> normal = difference_normal(samples, by_differences, doubts[i]);
      if (!normal || dot(*normal, areas[vertex]) <= 0) continue;
      wanted[vertex] = 0;
      settled.set(vertex, *normal);
    }
  });
  Zeroed<Vector> fans(vertices.size());
  for_each_triangle(mesh, runs, cancel, [&](const std::array<std::uint32_t, 3>& triangle) {
    if ((wanted[triangle[0]] | wanted[triangle[1]] | wanted[triangle[2]]) == 0) return;
    const std::array<Vector, 3> weighted = angle_weighted_normals(corners_of(mesh, triangle));
    for (std::size_t k = 0; k < 3; ++k) fans[triangle[k]] = fans[triangle[k]] + weighted[k];
  });
  for (const DoubtfulVertex& doubt : doubts) {
    if (wanted[doubt.number] == 0) continue;
    const Vector fan = normalized(fans[doubt.number]);
    settled.set(doubt.number, fan == Vector{} ? Vector{0, 0, 1} : fan);
  }
}

}  // namespace dini
