#include "geometry/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algebra/elementary.h"
#include "geometry/normals.h"
#include "geometry/validate.h"

namespace dini {

namespace {

std::optional<ImportError> bad_number(const RawMesh& raw) {
  const auto at = [](const char* what, std::size_t index) {
    return invalid_file(std::string(what) + " of vertex " + std::to_string(index) + " is not finite or too large");
  };
  const auto usable = [](double x) { return std::abs(x) < largest_coordinate; };
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    const Vector& p = raw.positions[i];
    if (!usable(p.x) || !usable(p.y) || !usable(p.z)) return at("the position", i);
  }
  for (std::size_t i = 0; i < raw.normals.size(); ++i) {
    if (!is_finite(raw.normals[i])) return at("the normal", i);
  }
  for (std::size_t i = 0; i < raw.uvs.size(); ++i) {
    if (!usable(raw.uvs[i][0]) || !usable(raw.uvs[i][1])) return at("a texture coordinate", i);
  }
  for (std::size_t i = 0; i < raw.colors.size(); ++i) {
    for (const float channel : raw.colors[i]) {
      if (!std::isfinite(channel)) return at("the color", i);
    }
  }
  return std::nullopt;
}

void drop_degenerate(RawMesh& raw) {
  std::erase_if(raw.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

/// The vertices that triangles use, in their order; renumbers the triangles.
std::vector<std::uint32_t> used_vertices(RawMesh& raw) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(raw.positions.size(), unused);
  for (const auto& triangle : raw.triangles) {
    for (const std::uint32_t vertex : triangle) number[vertex] = 0;
  }
  std::vector<std::uint32_t> used;
  for (std::uint32_t vertex = 0; vertex < number.size(); ++vertex) {
    if (number[vertex] == unused) continue;
    number[vertex] = static_cast<std::uint32_t>(used.size());
    used.push_back(vertex);
  }
  for (auto& triangle : raw.triangles) {
    for (std::uint32_t& vertex : triangle) vertex = number[vertex];
  }
  return used;
}

void set_normals(const RawMesh& raw, const std::vector<std::uint32_t>& used, const Cancel& cancel, Mesh& mesh) {
  Column<Vector> normals(used.size());
  bool complete = !raw.normals.empty();
  for (std::size_t i = 0; i < used.size() && !raw.normals.empty(); ++i) {
    const Vector normal = normalized(raw.normals[used[i]]);
    complete = complete && normal != Vector{};
    normals.set(i, normal);
  }
  if (!complete) {
    const Column<Vector> computed = smooth_normals(mesh, cancel);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (normals[i] == Vector{}) normals.set(i, computed[i]);
    }
  }
  mesh.normals = std::move(normals);
}

}  // namespace

ImportResult finish_import(RawMesh raw, MeshFormat format, const ImportLimits& limits, const Cancel& cancel) {
  if (cancel.stopped()) return stopped_reading();
  if (auto error = bad_number(raw)) return *std::move(error);
  drop_degenerate(raw);
  if (raw.triangles.empty()) return invalid_file("the file has no triangles");
  if (raw.triangles.size() > limits.triangles) return too_many(limits.triangles, "triangles");
  const std::vector<std::uint32_t> used = used_vertices(raw);
  if (used.size() > limits.vertices) return too_many(limits.vertices, "vertices");
  // Each pass over a file within the limits takes milliseconds, apart from the normals, which look for themselves.
  if (cancel.stopped()) return stopped_reading();
  ImportedMesh result{{}, format};
  Mesh& mesh = result.mesh;
  mesh.triangles = std::move(raw.triangles);
  mesh.positions = Column<Point>(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) mesh.positions.set(i, to_point(raw.positions[used[i]]));
  for (const std::uint32_t vertex : used) {
    if (!raw.uvs.empty()) mesh.uvs.push_back(raw.uvs[vertex]);
    if (raw.colors.empty()) continue;
    mesh.colors.push_back(raw.colors[vertex]);
    for (float& channel : mesh.colors.back()) channel = std::clamp(channel, 0.0f, 1.0f);
  }
  set_normals(raw, used, cancel, mesh);
  if (cancel.stopped()) return stopped_reading();
  if (auto defect = mesh_defect(mesh)) return invalid_file(*defect);
  return result;
}

float linear_color(double stored) {
  const double share = std::clamp(stored, 0.0, 1.0);
  return static_cast<float>(share <= 0.04045 ? share / 12.92 : elementary::pow((share + 0.055) / 1.055, 2.4));
}

}  // namespace dini
