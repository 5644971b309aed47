// What optimizers see of the values on wires.

#include "fitting/model.h"

namespace dini::fitting {
namespace {

void append(std::vector<double>& numbers, const Vector& vector) {
  numbers.insert(numbers.end(), {vector.x, vector.y, vector.z});
}

void append(Surface& surface, const Mesh& mesh) {
  const auto before = static_cast<std::uint32_t>(surface.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) surface.positions.push_back(to_vector(mesh.positions[i]));
  for (const auto& [a, b, c] : mesh.triangles) surface.triangles.push_back({before + a, before + b, before + c});
}

}  // namespace

std::optional<std::vector<double>> numbers_of(const Value& value) {
  std::vector<double> numbers;
  if (value.type() == WireType::number) {
    const Column<double>& column = column_of<double>(value);
    for (std::size_t i = 0; i < column.size(); ++i) numbers.push_back(column[i]);
  } else if (value.type() == WireType::vector) {
    const Column<Vector>& column = column_of<Vector>(value);
    for (std::size_t i = 0; i < column.size(); ++i) append(numbers, column[i]);
  } else if (value.type() == WireType::point) {
    const Column<Point>& column = column_of<Point>(value);
    for (std::size_t i = 0; i < column.size(); ++i) append(numbers, to_vector(column[i]));
  } else {
    return std::nullopt;
  }
  return numbers;
}

Surface surface_of(const Value& value) {
  Surface surface;
  const Column<SharedMesh>& meshes = column_of<SharedMesh>(value);
  for (std::size_t i = 0; i < meshes.size(); ++i) append(surface, *meshes[i]);
  return surface;
}

}  // namespace dini::fitting
