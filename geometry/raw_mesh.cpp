#include "geometry/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/counted.h"
#include "geometry/normals.h"
#include "geometry/validate.h"

namespace dini {

namespace {

bool is_usable(const std::array<double, 2>& uv) {
  return std::abs(uv[0]) < largest_coordinate && std::abs(uv[1]) < largest_coordinate;
}

bool is_usable(const std::array<float, 4>& color) {
  return std::all_of(color.begin(), color.end(), [](float channel) { return std::isfinite(channel); });
}

void warn(RawMesh& raw, std::size_t count, std::string_view one, std::string_view many) {
  if (count > 0) raw.warnings.push_back(counted(count, one, many));
}

/// With the reason, as far as it is known.
ImportError nothing_left(const RawMesh& raw) {
  std::string detail = "the file has no triangles";
  for (const std::string& warning : raw.warnings) detail += "; " + warning;
  return invalid_file(std::move(detail));
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

void set_uvs(RawMesh& raw, const std::vector<std::uint32_t>& used, Mesh& mesh) {
  if (raw.uvs.empty()) return;
  std::size_t lost = 0;
  auto& uvs = mesh.uvs.edit();
  for (const std::uint32_t vertex : used) {
    const bool usable = is_usable(raw.uvs[vertex]);
    uvs.push_back(usable ? raw.uvs[vertex] : std::array<double, 2>{0, 0});
    if (usable) continue;
    ++lost;
  }
  warn(raw, lost, "texture coordinate is not finite or beyond 1e18 and becomes 0",
       "texture coordinates are not finite or beyond 1e18 and become 0");
}

void set_colors(RawMesh& raw, const std::vector<std::uint32_t>& used, Mesh& mesh) {
  if (raw.colors.empty()) return;
  std::size_t lost = 0;
  auto& colors = mesh.colors.edit();
  for (const std::uint32_t vertex : used) {
    colors.push_back(raw.colors[vertex]);
    if (!is_usable(colors.back())) {
      colors.back() = {1, 1, 1, 1};
      ++lost;
    }
    for (float& channel : colors.back()) channel = std::clamp(channel, 0.0f, 1.0f);
  }
  warn(raw, lost, "color is not finite and becomes white", "colors are not finite and become white");
}

void set_normals(RawMesh& raw, const std::vector<std::uint32_t>& used, const Cancel& cancel, Mesh& mesh) {
  Column<Vector> normals(used.size());
  bool complete = !raw.normals.empty();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < used.size() && !raw.normals.empty(); ++i) {
    const bool usable = is_finite(raw.normals[used[i]]);
    const Vector normal = usable ? normalized(raw.normals[used[i]]) : Vector{};
    lost += usable ? 0 : 1;
    complete = complete && normal != Vector{};
    normals.set(i, normal);
  }
  warn(raw, lost, "normal is zero or not finite and is computed", "normals are zero or not finite and are computed");
  if (!complete) {
    const Column<Vector> computed = smooth_normals(mesh, cancel);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (normals[i] == Vector{}) normals.set(i, computed[i]);
    }
  }
  mesh.normals = std::move(normals);
}

}  // namespace

Vector given_normal(const Vector& normal) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  return is_finite(normal) && normal != Vector{} ? normal : Vector{undefined, undefined, undefined};
}

ImportResult finish_import(RawMesh raw, MeshFormat format, const ImportLimits& limits, const Cancel& cancel) {
  if (cancel.stopped()) return stopped_reading();
  if (raw.triangles.empty()) return nothing_left(raw);
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
  set_uvs(raw, used, mesh);
  set_colors(raw, used, mesh);
  set_normals(raw, used, cancel, mesh);
  if (cancel.stopped()) return stopped_reading();
  if (auto defect = mesh_defect(mesh)) return invalid_file(*defect);
  result.warnings = std::move(raw.warnings);
  return result;
}

}  // namespace dini
