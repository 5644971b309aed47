#include "gltf/glb_mesh_builder.h"

#include <algorithm>

#include "geometry/counted.h"
#include "geometry/flat_normals.h"
#include "geometry/validate.h"

namespace dini {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Vector vector_at(const GltfAccessor& accessor, std::size_t index) {
  return {accessor.number(index, 0), accessor.number(index, 1), accessor.number(index, 2)};
}

/// The vertices that triangles use, ascending; renumbers the triangles by their places in there.
std::vector<std::uint32_t> take_used(Triangles& triangles, std::size_t count) {
  std::vector<std::uint32_t> used;
  for (const auto& triangle : triangles) used.insert(used.end(), triangle.begin(), triangle.end());
  const bool few = used.size() < count / 4;
  // A table over all vertices is quicker, but 25 triangles may stand in an accessor of a million.
  std::vector<std::uint32_t> number(few ? 0 : count);
  if (few) {
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
  } else {
    for (const std::uint32_t vertex : used) number[vertex] = 1;
    used.clear();
    for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
      if (number[vertex] == 0) continue;
      number[vertex] = static_cast<std::uint32_t>(used.size());
      used.push_back(vertex);
    }
  }
  for (auto& triangle : triangles) {
    for (std::uint32_t& vertex : triangle) {
      vertex = few ? static_cast<std::uint32_t>(std::ranges::lower_bound(used, vertex) - used.begin()) : number[vertex];
    }
  }
  return used;
}

}  // namespace

void GlbMeshBuilder::add(const GltfJson& primitive, const GltfPlace& place, const std::string& name) {
  const auto mode = GltfPrimitive::mode_of(primitive);
  if (!mode) {
    ++points_and_lines_;
    return;
  }
  const GltfPrimitive parts(document_, primitive, *mode);
  GltfTriangles triangles(document_, parts, limits_.triangles - std::min(raw_.triangles.size(), limits_.triangles));
  faces_.count_repeated(triangles.repeated);
  without_area_ += triangles.without_area;
  const std::size_t first_vertex = raw_.positions.size(), first_triangle = raw_.triangles.size();
  const std::vector<std::uint32_t> vertices = take_used(triangles.list, parts.positions->count());
  if (vertices.size() > limits_.vertices - std::min(first_vertex, limits_.vertices)) {
    throw GltfRefused{too_many(limits_.vertices, "vertices")};
  }
  std::vector<bool> mirrored;
  add_vertices(parts, vertices, place, mirrored);
  for (auto triangle : triangles.list) {
    if (mirrored[triangle[0]]) std::swap(triangle[1], triangle[2]);
    std::array<Vector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] += static_cast<std::uint32_t>(first_vertex);
      corners[k] = raw_.positions[triangle[k]];
    }
    const auto at = [&] {
      const auto lost = std::ranges::find_if_not(corners, [](const Vector& p) { return is_within_reach(to_point(p)); });
      const std::uint32_t vertex = triangle[static_cast<std::size_t>(lost - corners.begin())];
      return name + ", vertex " + std::to_string(vertices[vertex - first_vertex]);
    };
    if (faces_.takes(corners, at)) faces_.add(triangle, corners, raw_);
  }
  if (parts.normals == nullptr && !make_flat(raw_, first_vertex, first_triangle, limits_.vertices, cancel_)) {
    smooth_ += triangles.list.size();
  }
}

void GlbMeshBuilder::add_vertices(const GltfPrimitive& primitive, const std::vector<std::uint32_t>& vertices,
                                  const GltfPlace& place, std::vector<bool>& mirrored) {
  any_uv_ = any_uv_ || primitive.uvs != nullptr;
  any_color_ = any_color_ || primitive.colors != nullptr || !primitive.material.is_plain();
  const bool skinned = place.pose != nullptr && !primitive.weights.empty();
  for (const std::uint32_t vertex : vertices) {
    document_.step();
    const Affine map = skinned ? primitive.weights.place(*place.pose, vertex) : place.node;
    mirrored.push_back(map.mirrors());
    add_attributes(primitive, vertex, map);
  }
}

void GlbMeshBuilder::add_attributes(const GltfPrimitive& primitive, std::uint32_t vertex, const Affine& map) {
  raw_.positions.push_back(map(vector_at(*primitive.positions, vertex)));
  raw_.normals.emplace_back();
  if (primitive.normals != nullptr) {
    const double side = map.mirrors() ? -1 : 1;
    raw_.normals.back() = given_normal(side * map.normal(vector_at(*primitive.normals, vertex)));
  }
  raw_.uvs.push_back({0, 0});
  if (primitive.uvs != nullptr) raw_.uvs.back() = {primitive.uvs->number(vertex, 0), primitive.uvs->number(vertex, 1)};
  std::array<double, 4> color = {1, 1, 1, 1};
  for (std::size_t k = 0; primitive.colors != nullptr && k < primitive.colors->width(); ++k) {
    color[k] = primitive.colors->number(vertex, k, true);
  }
  raw_.colors.push_back(primitive.material.color(color));
  cut_away_ += primitive.material.cuts_away(color) ? 1 : 0;
}

RawMesh GlbMeshBuilder::finish() {
  if (!any_uv_) raw_.uvs.clear();
  if (!any_color_) raw_.colors.clear();
  faces_.warn(raw_.warnings);
  const auto tell = [&](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) raw_.warnings.push_back(counted(count, one, many));
  };
  tell(points_and_lines_, "primitive of points or lines is left out", "primitives of points or lines are left out");
  tell(without_area_, "triangle has no area, since its positions do not stand in the file, and is left out",
       "triangles have no area, since their positions do not stand in the file, and are left out");
  tell(smooth_, "triangle without normals gets smooth ones, since flat ones need more vertices than the limit",
       "triangles without normals get smooth ones, since flat ones need more vertices than the limit");
  tell(cut_away_, "vertex lies below the alpha cutoff of its material and becomes transparent",
       "vertices lie below the alpha cutoff of their material and become transparent");
  return std::move(raw_);
}

}  // namespace dini
