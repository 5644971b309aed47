#include "geometry/primitives.h"

#include <algorithm>
#include <limits>

#include "geometry/angle.h"
#include "geometry/surface.h"

namespace dini {

namespace {

constexpr double largest_size = 1e16;

bool usable(double size) { return size > 0 && size <= largest_size; }
bool usable(const Point& center) { return is_finite(center) && length(to_vector(center)) <= largest_size; }

/// The surface of a grid about which nothing is in doubt, so nothing is clipped.
Mesh whole_surface(const PointGrid& grid, const Cancel& cancel) {
  SurfaceOptions options;
  options.clip_radius = std::numeric_limits<double>::infinity();
  return surface(grid, options, cancel).mesh;
}

}  // namespace

Mesh sphere_mesh(const Point& center, double radius, std::size_t segments, std::size_t rings, const Cancel& cancel) {
  if (!usable(radius) || !usable(center)) return {};
  segments = std::max<std::size_t>(segments, 3);
  rings = std::max<std::size_t>(rings, 2);
  const auto normal_at = [](double u, double v) -> Vector {
    const SineCosine polar = sine_cosine(u / 2);
    const SineCosine around = sine_cosine(v);
    return {polar.sine * around.cosine, polar.sine * around.sine, polar.cosine};
  };
  Column<Point> points((rings + 1) * segments);
  for (std::size_t row = 0; row <= rings; ++row) {
    if (cancel.stopped()) return {};
    for (std::size_t column = 0; column < segments; ++column) {
      const Vector normal = normal_at(static_cast<double>(row) / static_cast<double>(rings),
                                      static_cast<double>(column) / static_cast<double>(segments));
      points.set(row * segments + column, to_point(to_vector(center) + radius * normal));
    }
  }
  Mesh mesh = whole_surface({.points = points, .rows = rings + 1, .columns = segments, .closed_columns = true}, cancel);
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < mesh.normals.size() && !steps.stopped(); ++i) {
    mesh.normals.set(i, normal_at(mesh.uvs[i][0], mesh.uvs[i][1]));
  }
  return mesh;
}

Mesh torus_mesh(const Point& center, const Vector& axis, double major_radius, double minor_radius, std::size_t segments,
                std::size_t sides, const Cancel& cancel) {
  if (!usable(major_radius) || !usable(minor_radius) || !usable(center) || !is_finite(axis)) return {};
  segments = std::max<std::size_t>(segments, 3);
  sides = std::max<std::size_t>(sides, 3);
  const Vector up = axis == Vector{} ? Vector{0, 0, 1} : normalized(axis);
  const Vector ahead = any_perpendicular(up);
  const Vector left = cross(up, ahead);
  const auto spoke_at = [&](double u) {
    const SineCosine around = sine_cosine(u);
    return around.cosine * ahead + around.sine * left;
  };
  const auto normal_at = [&](const Vector& spoke, double v) {
    const SineCosine tube = sine_cosine(v);
    return tube.cosine * spoke + tube.sine * up;
  };
  Column<Point> points(segments * sides);
  for (std::size_t row = 0; row < segments; ++row) {
    if (cancel.stopped()) return {};
    const Vector spoke = spoke_at(static_cast<double>(row) / static_cast<double>(segments));
    for (std::size_t column = 0; column < sides; ++column) {
      const Vector normal = normal_at(spoke, static_cast<double>(column) / static_cast<double>(sides));
      points.set(row * sides + column, to_point(to_vector(center) + major_radius * spoke + minor_radius * normal));
    }
  }
  Mesh mesh = whole_surface(
      {.points = points, .rows = segments, .columns = sides, .closed_rows = true, .closed_columns = true}, cancel);
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < mesh.normals.size() && !steps.stopped(); ++i) {
    mesh.normals.set(i, normalized(normal_at(spoke_at(mesh.uvs[i][0]), mesh.uvs[i][1])));
  }
  return mesh;
}

}  // namespace dini
