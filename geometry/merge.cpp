#include "geometry/merge.h"

#include <algorithm>

#include "geometry/normals.h"

namespace dini {

namespace {

/// What the merged mesh has: the union of what its parts have.
struct Outline {
  std::size_t vertices = 0, triangles = 0;
  bool normals = false, uvs = false, colors = false;
  const Mesh* first = nullptr;
};

Outline outline_of(std::span<const SharedMesh> meshes) {
  Outline outline;
  for (const SharedMesh& mesh : meshes) {
    if (!mesh) continue;
    if (!outline.first) outline.first = mesh.get();
    outline.vertices += mesh->positions.size();
    outline.triangles += mesh->triangles.size();
    outline.normals |= !mesh->normals.empty();
    outline.uvs |= !mesh->uvs.empty();
    outline.colors |= !mesh->colors.empty() || mesh->color != outline.first->color;
  }
  return outline;
}

/// Writes a column into a larger one.
template <class T>
void place(const Column<T>& items, Column<T>& whole, std::size_t base, const Cancel& cancel) {
  for (std::size_t k = 0; k < Column<T>::width; ++k) {
    if (cancel.stopped()) return;
    std::copy_n(items.component(k), items.size(), whole.component(k) + base);
  }
}

void append_attributes(const Mesh& mesh, const Outline& outline, Mesh& merged, std::size_t base, const Cancel& cancel) {
  const std::size_t count = mesh.positions.size();
  place(*mesh.positions, merged.positions.edit(), base, cancel);
  if (outline.normals) {
    const Column<Vector> computed = mesh.normals.empty() ? smooth_normals(mesh, cancel) : Column<Vector>();
    const Column<Vector>& normals = mesh.normals.empty() ? computed : *mesh.normals;
    place(normals, merged.normals.edit(), base, cancel);
  }
  if (outline.uvs) {
    auto& uvs = merged.uvs.edit();
    uvs.insert(uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    uvs.resize(base + count, {0, 0});
  }
  if (outline.colors) {
    std::array<float, 4> fill{};
    std::transform(mesh.color.begin(), mesh.color.end(), fill.begin(), [](double c) { return static_cast<float>(c); });
    auto& colors = merged.colors.edit();
    colors.insert(colors.end(), mesh.colors.begin(), mesh.colors.end());
    colors.resize(base + count, fill);
  }
}

void append_triangles(const Mesh& mesh, Mesh& merged, std::size_t base, const Cancel& cancel) {
  const auto shift = static_cast<std::uint32_t>(base);
  const std::size_t first = merged.triangles.size();
  auto& triangles = merged.triangles.edit();
  CancelEvery steps(cancel);
  for (const auto& [a, b, c] : mesh.triangles) {
    if (steps.stopped()) return;
    triangles.push_back({a + shift, b + shift, c + shift});
  }
  for (const std::size_t end : mesh.tile_ends) merged.tile_ends.push_back(first + end);
  if (mesh.tile_ends.empty() && !mesh.triangles.empty()) merged.tile_ends.push_back(merged.triangles.size());
}

}  // namespace

Mesh merge(std::span<const SharedMesh> meshes, const Cancel& cancel) {
  const Outline outline = outline_of(meshes);
  Mesh merged;
  if (!outline.first) return merged;
  merged.color = outline.first->color;
  merged.finish = outline.first->finish;
  merged.positions = Column<Point>(outline.vertices);
  if (outline.normals) merged.normals = Column<Vector>(outline.vertices);
  if (outline.uvs) merged.uvs.reserve(outline.vertices);
  if (outline.colors) merged.colors.reserve(outline.vertices);
  merged.triangles.reserve(outline.triangles);
  std::size_t base = 0;
  for (const SharedMesh& mesh : meshes) {
    if (!mesh) continue;
    if (cancel.stopped()) return {};
    append_attributes(*mesh, outline, merged, base, cancel);
    append_triangles(*mesh, merged, base, cancel);
    base += mesh->positions.size();
  }
  return merged;
}

}  // namespace dini
