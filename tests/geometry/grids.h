#pragma once

#include <catch2/catch.hpp>

#include "geometry/angle.h"
#include "geometry/measure.h"
#include "geometry/surface.h"
#include "geometry/validate.h"
#include "tests/support/never_stopped.h"

namespace dini::support {

/// A grid of points made by a function of (u, v); closed axes leave their end out.
struct Grid {
  Column<Point> points;
  std::size_t rows, columns;
  bool closed_rows, closed_columns;

  template <class Map>
  Grid(std::size_t row_count, std::size_t column_count, bool close_rows, bool close_columns, Map map)
      : points(row_count * column_count),
        rows(row_count),
        columns(column_count),
        closed_rows(close_rows),
        closed_columns(close_columns) {
    const auto part = [](std::size_t index, std::size_t count, bool closed) {
      const std::size_t whole = closed ? count : count - 1;
      return whole == 0 ? 0.0 : static_cast<double>(index) / static_cast<double>(whole);
    };
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        points.set(row * columns + column, map(part(row, rows, closed_rows), part(column, columns, closed_columns)));
      }
    }
  }

  PointGrid view() const {
    return {.points = points,
            .rows = rows,
            .columns = columns,
            .closed_rows = closed_rows,
            .closed_columns = closed_columns};
  }
};

inline SurfaceResult surface_of(const Grid& grid, const SurfaceOptions& options = {}) {
  SurfaceResult result = surface(grid.view(), options, never_stopped);
  const auto defect = mesh_defect(result.mesh);
  INFO(defect.value_or("no defect"));
  CHECK(!defect);
  return result;
}

inline Point torus_point(double u, double v, double major_radius = 2, double minor_radius = 0.5) {
  const SineCosine around = sine_cosine(u), tube = sine_cosine(v);
  const double reach = major_radius + minor_radius * tube.cosine;
  return {reach * around.cosine, reach * around.sine, minor_radius * tube.sine};
}

/// u from the upper pole to the lower one.
inline Point sphere_point(double u, double v) {
  const SineCosine polar = sine_cosine(u / 2), around = sine_cosine(v);
  return {polar.sine * around.cosine, polar.sine * around.sine, polar.cosine};
}

inline Measures measured(const Mesh& mesh) { return measure(mesh, never_stopped); }

/// The smallest height of any triangle.
inline double least_height(const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector a = to_vector(mesh.positions[i]), b = to_vector(mesh.positions[j]), c = to_vector(mesh.positions[k]);
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    least = std::min(least, length(cross(b - a, c - a)) / longest);
  }
  return least;
}

/// Whether every vertex normal looks to the front of every triangle around it.
inline bool normals_match_faces(const Mesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return to_vector(mesh.positions[triangle[k]]); };
    const Vector face = cross(corner(1) - corner(0), corner(2) - corner(0));
    for (const std::uint32_t vertex : triangle) {
      if (!(dot(mesh.normals[vertex], face) > 0)) return false;
    }
  }
  return true;
}

/// The largest distance of vertex normals from those of `normal_at(position)`.
template <class NormalAt>
double normal_error(const Mesh& mesh, NormalAt normal_at) {
  double error = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    error = std::max(error, length(mesh.normals[i] - normal_at(mesh.positions[i])));
  }
  return error;
}

inline Vector sphere_normal(const Point& p) { return normalized(to_vector(p)); }

inline Vector torus_normal(const Point& p, double major_radius = 2) {
  const Vector spoke = normalized(Vector{p.x, p.y, 0});
  return normalized(to_vector(p) - major_radius * spoke);
}

/// The largest number of triangles in a tile.
inline std::size_t largest_tile(const Mesh& mesh) {
  std::size_t begin = 0, largest = 0;
  for (const std::size_t end : mesh.tile_ends) {
    largest = std::max(largest, end - begin);
    begin = end;
  }
  return largest;
}

}  // namespace dini::support
