#include "geometry/box.h"

#include <algorithm>
#include <cmath>

namespace dini {

namespace {

constexpr double largest_size = 1e16;

bool usable(double size) { return size > 0 && size <= largest_size; }
bool usable_place(double coordinate) { return std::abs(coordinate) <= largest_size; }

/// One face: its outward axis is `along`, positive or negative; u and v are the next two axes in the order that makes
/// u x v point outward.
struct Face {
  std::size_t along;
  bool positive;
};

}  // namespace

Mesh box_mesh(const Point& center, const Vector& size, std::size_t segments, const Cancel& cancel) {
  if (!usable(size.x) || !usable(size.y) || !usable(size.z)) return {};
  if (!usable_place(center.x) || !usable_place(center.y) || !usable_place(center.z)) return {};
  const std::size_t steps = std::max<std::size_t>(segments, 1), points = steps + 1;
  const std::array<double, 3> middle = {center.x, center.y, center.z}, edges = {size.x, size.y, size.z};
  // One formula for every face, so that faces meet exactly.
  const auto coordinate = [&](std::size_t axis, std::size_t step) {
    const double share = static_cast<double>(step) / static_cast<double>(steps);
    return middle[axis] + (share - 0.5) * edges[axis];
  };
  Mesh mesh;
  mesh.positions = Column<Point>(6 * points * points);
  mesh.normals = Column<Vector>(6 * points * points);
  std::size_t vertex = 0;
  for (const Face face :
       {Face{0, false}, Face{0, true}, Face{1, false}, Face{1, true}, Face{2, false}, Face{2, true}}) {
    const std::size_t u_axis = (face.along + (face.positive ? 1 : 2)) % 3,
                      v_axis = (face.along + (face.positive ? 2 : 1)) % 3;
    std::array<double, 3> normal = {0, 0, 0};
    normal[face.along] = face.positive ? 1 : -1;
    const std::size_t first = vertex;
    for (std::size_t i = 0; i < points; ++i) {
      if (cancel.stopped()) return {};
      for (std::size_t j = 0; j < points; ++j, ++vertex) {
        std::array<double, 3> place{};
        place[face.along] = coordinate(face.along, face.positive ? steps : 0);
        place[u_axis] = coordinate(u_axis, i);
        place[v_axis] = coordinate(v_axis, j);
        mesh.positions.set(vertex, {place[0], place[1], place[2]});
        mesh.normals.set(vertex, {normal[0], normal[1], normal[2]});
        mesh.uvs.push_back(
            {static_cast<double>(i) / static_cast<double>(steps), static_cast<double>(j) / static_cast<double>(steps)});
      }
    }
    for (std::size_t i = 0; i < steps; ++i) {
      if (cancel.stopped()) return {};
      for (std::size_t j = 0; j < steps; ++j) {
        const auto corner = static_cast<std::uint32_t>(first + i * points + j);
        const auto ahead = static_cast<std::uint32_t>(corner + points);
        mesh.triangles.push_back({corner, ahead, ahead + 1});
        mesh.triangles.push_back({corner, ahead + 1, corner + 1});
      }
    }
    mesh.tile_ends.push_back(mesh.triangles.size());
  }
  return mesh;
}

}  // namespace dini
