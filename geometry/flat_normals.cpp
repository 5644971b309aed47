#include "geometry/flat_normals.h"

#include <algorithm>
#include <cmath>

#include "geometry/vertex_splitter.h"

namespace dini {

namespace {

Vector plane_normal(const RawMesh& raw, const std::array<std::uint32_t, 3>& triangle) {
  const Vector a = raw.positions[triangle[0]];
  return normalized(cross(raw.positions[triangle[1]] - a, raw.positions[triangle[2]] - a));
}

/// Equal for normals that differ in round-off only, as those of the two halves of a quad do.
VertexSplitter::Value rounded(const Vector& normal) {
  const auto part = [](double value) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(std::ldexp(value, 20))));
  };
  return {part(normal.x), part(normal.y), part(normal.z), 0};
}

}  // namespace

bool make_flat(RawMesh& raw, std::size_t first_vertex, std::size_t first_triangle, std::size_t most_vertices,
               const Cancel& cancel) {
  VertexSplitter splitter(first_vertex, raw.positions.size());
  const std::size_t spare = most_vertices - std::min(most_vertices, raw.positions.size());
  std::vector<std::array<std::uint32_t, 3>> triangles;
  CancelEvery steps(cancel);
  for (std::size_t i = first_triangle; i < raw.triangles.size(); ++i) {
    auto triangle = raw.triangles[i];
    const VertexSplitter::Value value = rounded(plane_normal(raw, triangle));
    for (std::uint32_t& vertex : triangle) vertex = splitter.at(vertex, value);
    if (splitter.copies() > spare || steps.stopped()) return false;
    triangles.push_back(triangle);
  }
  raw.normals.resize(raw.positions.size());
  splitter.append_copies(raw);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vector normal = plane_normal(raw, raw.triangles[first_triangle + i]);
    raw.triangles[first_triangle + i] = triangles[i];
    for (const std::uint32_t vertex : triangles[i]) raw.normals[vertex] = normal;
  }
  return true;
}

}  // namespace dini
