#include "tests/gltf/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace dini::shapes {
namespace {

constexpr double full_turn = 6.283185307179586;

// Two triangles per quad of a grid of vertices; a wrapped direction joins its last vertices to its first.
void add_quads(Mesh& mesh, std::size_t rows, std::size_t columns, bool wrapped) {
  const auto vertex = [=](std::size_t row, std::size_t column) {
    return static_cast<std::uint32_t>((row % rows) * columns + column % columns);
  };
  const std::size_t open = wrapped ? 0 : 1;
  for (std::size_t row = 0; row + open < rows; ++row) {
    for (std::size_t column = 0; column + open < columns; ++column) {
      mesh.triangles.push_back({vertex(row, column), vertex(row, column + 1), vertex(row + 1, column)});
      mesh.triangles.push_back({vertex(row, column + 1), vertex(row + 1, column + 1), vertex(row + 1, column)});
    }
  }
}

}  // namespace

Mesh wavy_field(std::size_t rows, std::size_t columns, double waves) {
  Mesh mesh;
  mesh.positions = Column<Point>(rows * columns);
  mesh.normals = Column<Vector>(rows * columns);
  const double along = 7 * waves;
  const double across = 5 * waves;
  constexpr double height = 0.15;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = 2 * static_cast<double>(column) / static_cast<double>(columns - 1);
      const double y = 2 * static_cast<double>(row) / static_cast<double>(rows - 1);
      const double z = height * std::sin(along * x) * std::cos(across * y);
      const Vector normal = {-height * along * std::cos(along * x) * std::cos(across * y),
                             height * across * std::sin(along * x) * std::sin(across * y), 1};
      mesh.positions.set(row * columns + column, {x, y, z});
      mesh.normals.set(row * columns + column, normalized(normal));
      mesh.uvs.push_back({x / 2, y / 2});
    }
  }
  add_quads(mesh, rows, columns, false);
  return mesh;
}

Mesh torus(std::size_t around, std::size_t across) {
  Mesh mesh;
  mesh.positions = Column<Point>(around * across);
  mesh.normals = Column<Vector>(around * across);
  for (std::size_t i = 0; i < around; ++i) {
    const double u = full_turn * static_cast<double>(i) / static_cast<double>(around);
    for (std::size_t k = 0; k < across; ++k) {
      const double v = full_turn * static_cast<double>(k) / static_cast<double>(across);
      const Vector out = {std::cos(u), std::sin(u), 0};
      const Vector normal = std::cos(v) * out + Vector{0, 0, std::sin(v)};
      mesh.positions.set(i * across + k, to_point(out + 0.4 * normal));
      mesh.normals.set(i * across + k, normal);
    }
  }
  add_quads(mesh, around, across, true);
  return mesh;
}

Mesh single_triangle() {
  Mesh mesh;
  mesh.positions = Column<Point>(3);
  mesh.positions.set(1, {1, 0, 0});
  mesh.positions.set(2, {0, 1, 0});
  mesh.triangles.edit() = {{0, 1, 2}};
  return mesh;
}

Mesh random_soup(unsigned seed, std::size_t vertices, std::size_t triangles, double extent, double center) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<std::uint32_t> vertex(0, static_cast<std::uint32_t>(vertices - 1));
  Mesh mesh;
  mesh.positions = Column<Point>(vertices);
  mesh.normals = Column<Vector>(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto coordinate = [&] { return center + extent / 2 * unit(random); };
    mesh.positions.set(i, {coordinate(), coordinate(), coordinate()});
    mesh.normals.set(i, normalized({unit(random), unit(random), unit(random)}));
    mesh.uvs.push_back({unit(random), unit(random)});
    mesh.colors.push_back({static_cast<float>(unit(random)), 0.5f, 1.0f, 1.0f});
  }
  for (std::size_t i = 0; i < triangles; ++i)
    mesh.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  return mesh;
}

void cut_into_square_tiles(Mesh& mesh, std::size_t rows, std::size_t columns, std::size_t side) {
  const auto triangles = std::move(mesh.triangles);
  mesh.triangles.clear();
  mesh.tile_ends.clear();
  for (std::size_t row = 0; row < rows; row += side) {
    for (std::size_t column = 0; column < columns; column += side) {
      for (std::size_t i = row; i < std::min(row + side, rows); ++i) {
        for (std::size_t k = column; k < std::min(column + side, columns); ++k) {
          mesh.triangles.push_back(triangles[2 * (i * columns + k)]);
          mesh.triangles.push_back(triangles[2 * (i * columns + k) + 1]);
        }
      }
      mesh.tile_ends.push_back(mesh.triangles.size());
    }
  }
}

Polyline circle(std::size_t points, double radius, double height) {
  Polyline polyline;
  polyline.closed = true;
  polyline.points = Column<Point>(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = full_turn * static_cast<double>(i) / static_cast<double>(points);
    polyline.points.set(i, {radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return polyline;
}

Scene scene_of(Mesh mesh) {
  Scene scene;
  scene.parts.push_back({"mesh", std::make_shared<const Mesh>(std::move(mesh)), {}});
  return scene;
}

}  // namespace dini::shapes
