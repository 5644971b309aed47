#include "geometry/primitives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/angle.h"
#include "geometry/chunks.h"
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

/// The sines and cosines of `count` even parts of `turns` turns, and with an open axis of its end.
std::vector<SineCosine> even_angles(std::size_t count, double turns, bool closed) {
  std::vector<SineCosine> angles;
  for (std::size_t i = 0; i < count + (closed ? 0 : 1); ++i) {
    angles.push_back(sine_cosine(turns * (static_cast<double>(i) / static_cast<double>(count))));
  }
  return angles;
}

/// Which sample of an axis of `steps` steps has a texture coordinate.
std::size_t sample_at(double coordinate, std::size_t steps) {
  return static_cast<std::size_t>(std::lround(coordinate * static_cast<double>(steps)));
}

/// A surface over a grid of which all is known: `point(row, column)` and the unit `normal(row, column)` there.
template <class Place, class Normal>
Mesh known_surface(std::size_t rows, std::size_t row_steps, std::size_t columns, const Cancel& cancel, Place point,
                   Normal normal) {
  Column<Point> points(rows * columns);
  const std::size_t rows_at_once = std::max<std::size_t>(1, usual_chunk / columns);
  for_chunks(cancel, rows, rows_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        points.set(row * columns + column, to_point(point(row, column)));
      }
    }
  });
  if (cancel.stopped()) return {};
  Mesh mesh = whole_surface(
      {.points = points, .rows = rows, .columns = columns, .closed_rows = rows == row_steps, .closed_columns = true},
      cancel);
  Column<Vector>& normals = mesh.normals.edit();
  const auto& uvs = *mesh.uvs;
  for_chunks(cancel, normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      normals.set(i, normal(sample_at(uvs[i][0], row_steps), sample_at(uvs[i][1], columns)));
    }
  });
  return mesh;
}

}  // namespace

Mesh sphere_mesh(const Point& center, double radius, std::size_t segments, std::size_t rings, const Cancel& cancel) {
  if (!usable(radius) || !usable(center)) return {};
  segments = std::max<std::size_t>(segments, 3);
  rings = std::max<std::size_t>(rings, 2);
  const std::vector<SineCosine> polar = even_angles(rings, 0.5, false), around = even_angles(segments, 1, true);
  const auto normal = [&](std::size_t row, std::size_t column) -> Vector {
    return {polar[row].sine * around[column].cosine, polar[row].sine * around[column].sine, polar[row].cosine};
  };
  const auto point = [&](std::size_t row, std::size_t column) {
    return to_vector(center) + radius * normal(row, column);
  };
  return known_surface(rings + 1, rings, segments, cancel, point, normal);
}

Mesh torus_mesh(const Point& center, const Vector& axis, double major_radius, double minor_radius, std::size_t segments,
                std::size_t sides, const Cancel& cancel) {
  if (!usable(major_radius) || !usable(minor_radius) || !usable(center) || !is_finite(axis)) return {};
  segments = std::max<std::size_t>(segments, 3);
  sides = std::max<std::size_t>(sides, 3);
  const Vector up = axis == Vector{} ? Vector{0, 0, 1} : normalized(axis);
  const Vector ahead = any_perpendicular(up);
  const Vector left = cross(up, ahead);
  const std::vector<SineCosine> around = even_angles(segments, 1, true), tube = even_angles(sides, 1, true);
  std::vector<Vector> spokes;
  for (const SineCosine& turn : around) spokes.push_back(turn.cosine * ahead + turn.sine * left);
  const auto outward = [&](std::size_t row, std::size_t column) {
    return tube[column].cosine * spokes[row] + tube[column].sine * up;
  };
  const auto point = [&](std::size_t row, std::size_t column) {
    return to_vector(center) + major_radius * spokes[row] + minor_radius * outward(row, column);
  };
  return known_surface(segments, segments, sides, cancel, point,
                       [&](std::size_t row, std::size_t column) { return normalized(outward(row, column)); });
}

}  // namespace dini
