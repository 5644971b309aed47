#include "geometry/validate.h"

#include <cmath>

namespace dini {

bool is_within_reach(const Point& p) {
  return std::abs(p.x) < largest_coordinate && std::abs(p.y) < largest_coordinate && std::abs(p.z) < largest_coordinate;
}

namespace {

std::string numbered(const char* what, std::size_t index, const char* fault) {
  return std::string(what) + " " + std::to_string(index) + " " + fault;
}

std::optional<std::string> size_defect(const char* what, std::size_t size, std::size_t vertices) {
  if (size == 0 || size == vertices) return {};
  return std::to_string(size) + " " + what + " for " + std::to_string(vertices) + " vertices";
}

std::optional<std::string> attribute_defect(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!is_within_reach(mesh.positions[i])) return numbered("position", i, "is not finite or too large");
  }
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (!(std::abs(length(mesh.normals[i]) - 1) < 1e-6)) return numbered("normal", i, "is not of unit length");
  }
  for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
    if (!std::isfinite(mesh.uvs[i][0]) || !std::isfinite(mesh.uvs[i][1])) return numbered("uv", i, "is not finite");
  }
  for (std::size_t i = 0; i < mesh.colors.size(); ++i) {
    for (const float channel : mesh.colors[i]) {
      if (!(channel >= 0 && channel <= 1)) return numbered("color", i, "is outside [0, 1]");
    }
  }
  return {};
}

std::optional<std::string> tile_defect(const Mesh& mesh) {
  if (mesh.tile_ends.empty()) return {};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < mesh.tile_ends.size(); ++i) {
    if (mesh.tile_ends[i] <= begin) return numbered("tile", i, "is empty or out of order");
    begin = mesh.tile_ends[i];
  }
  if (begin != mesh.triangles.size()) return "the last tile does not end at the last triangle";
  return {};
}

}  // namespace

std::optional<std::string> mesh_defect(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (auto defect = size_defect("normals", mesh.normals.size(), vertices)) return defect;
  if (auto defect = size_defect("uvs", mesh.uvs.size(), vertices)) return defect;
  if (auto defect = size_defect("colors", mesh.colors.size(), vertices)) return defect;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (a >= vertices || b >= vertices || c >= vertices)
      return numbered("triangle", i, "uses a vertex that is not there");
    if (a == b || b == c || c == a) return numbered("triangle", i, "uses a vertex twice");
  }
  if (auto defect = attribute_defect(mesh)) return defect;
  return tile_defect(mesh);
}

}  // namespace dini
