#include "golden/shape.h"

#include "geometry/merge.h"
#include "gltf/glb_reader.h"

namespace dini {
namespace {

std::array<float, 4> as_floats(const Color& color) {
  return {static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]),
          static_cast<float>(color[3])};
}

std::uint32_t add_point(Shape& shape, const Point& point, const std::array<float, 4>& color) {
  shape.points.push_back(to_vector(point));
  shape.colors.push_back(color);
  return static_cast<std::uint32_t>(shape.points.size() - 1);
}

void add_mesh(Shape& shape, const Mesh& mesh) {
  const auto base = static_cast<std::uint32_t>(shape.points.size());
  const std::array<float, 4> own = as_floats(mesh.color);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    std::array<float, 4> color = own;
    if (!mesh.colors.empty()) {
      for (std::size_t k = 0; k < color.size(); ++k) color[k] *= mesh.colors[i][k];
    }
    add_point(shape, mesh.positions[i], color);
  }
  for (const auto& [a, b, c] : mesh.triangles) shape.pieces.push_back({base + a, base + b, base + c});
}

void add_polyline(Shape& shape, const Polyline& line, const Color& color) {
  const auto base = static_cast<std::uint32_t>(shape.points.size());
  for (std::size_t i = 0; i < line.points.size(); ++i) add_point(shape, line.points[i], as_floats(color));
  const auto count = static_cast<std::uint32_t>(line.points.size());
  for (std::uint32_t i = 0; i + 1 < count; ++i) shape.pieces.push_back({base + i, base + i + 1, base + i + 1});
  if (line.closed && count > 1) shape.pieces.push_back({base + count - 1, base, base});
}

void add_points(Shape& shape, const Column<Point>& points, const Color& color) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t point = add_point(shape, points[i], as_floats(color));
    shape.pieces.push_back({point, point, point});
  }
}

}  // namespace

Shape shape_of(const std::vector<Part>& parts) {
  Shape shape;
  std::vector<SharedMesh> meshes;
  for (const Part& part : parts) {
    if (const auto* mesh = std::get_if<SharedMesh>(&part.shape)) {
      add_mesh(shape, **mesh);
      meshes.push_back(*mesh);
    }
  }
  shape.triangles = shape.pieces.size();
  for (const Part& part : parts) {
    if (const auto* lines = std::get_if<std::vector<Polyline>>(&part.shape)) {
      for (const Polyline& line : *lines) add_polyline(shape, line, part.color);
    }
  }
  shape.segments = shape.pieces.size() - shape.triangles;
  for (const Part& part : parts) {
    if (const auto* points = std::get_if<SharedColumn<Point>>(&part.shape)) add_points(shape, **points, part.color);
  }
  shape.measures = measure(merge(meshes, Cancel()), Cancel());
  return shape;
}

std::optional<Shape> read_shape(std::string_view glb) {
  const std::optional<Scene> scene = read_glb(glb);
  if (!scene) return std::nullopt;
  return shape_of(scene->parts);
}

}  // namespace dini
