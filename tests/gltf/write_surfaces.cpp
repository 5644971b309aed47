// Writes surfaces by chance, regular and irregular, and beside each one what it was made of, for
// tools/check_errors.mjs:
//   write_gltf_surfaces DIRECTORY COUNT

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "geometry/json.h"
#include "gltf/glb_writer.h"
#include "tests/draco/grids.h"
#include "tests/gltf/shapes.h"

namespace dini {
namespace {

double number(double least, double most, std::mt19937& random) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

/// A smooth or rough surface over these triangles, of any size and at any place.
Mesh over(const grids::TriangleList& list, std::mt19937& random) {
  const double size = std::pow(10.0, number(-6, 6, random));
  const double roughness = number(0, 1, random) < 0.5 ? 0.01 : 1;
  const Vector place = {number(-10, 10, random), number(-10, 10, random), number(-10, 10, random)};
  Mesh mesh;
  mesh.positions = Column<Point>(list.vertices);
  mesh.normals = Column<Vector>(list.vertices);
  for (std::size_t i = 0; i < list.vertices; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(list.vertices);
    const auto value = [&](double from) { return size * (from + along + number(-roughness, roughness, random)); };
    mesh.positions.set(i, {value(place.x), value(place.y), value(place.z)});
    mesh.normals.set(i, normalized(Vector{number(-1, 1, random), number(-1, 1, random), 1.5}));
    mesh.uvs.push_back({along, number(0, 1, random)});
  }
  for (const auto& triangle : list.triangles) mesh.triangles.push_back(triangle);
  return mesh;
}

Mesh surface(int number, std::mt19937& random) {
  const auto few = static_cast<unsigned>(number);
  if (number % 10 == 9) return shapes::random_soup(few, 100, 300, std::pow(10.0, number % 7 - 3), number % 3);
  return over(grids::any(number % 50 == 0 ? 30 : 12, random), random);
}

/// The positions that triangles use: others are in no file.
Json used_positions(const Mesh& mesh) {
  std::set<std::uint32_t> used;
  for (const auto& triangle : mesh.triangles) used.insert(triangle.begin(), triangle.end());
  Json positions = Json::array();
  for (const std::uint32_t i : used) {
    const Point p = mesh.positions[i];
    for (const double value : {p.x, p.y, p.z}) positions.push_back(value);
  }
  return positions;
}

int write_surfaces(const std::filesystem::path& directory, int count) {
  std::filesystem::create_directories(directory);
  std::mt19937 random(2027);
  for (int i = 0; i < count; ++i) {
    const Mesh mesh = surface(i, random);
    EncodeOptions options;
    options.position_bits = 8 + i % 13;
    options.speed = i % 11;
    const auto encoded = encode_scene(shapes::scene_of(mesh), options, Cancel());
    if (!encoded) {
      std::fprintf(stderr, "surface %d: %s\n", i, encoded.error().detail.c_str());
      return 1;
    }
    const Json made_of = {{"position_error", encoded->position_error}, {"positions", used_positions(mesh)}};
    std::ofstream(directory / (std::to_string(i) + ".glb"), std::ios::binary) << encoded->file;
    std::ofstream(directory / (std::to_string(i) + ".made_of.json")) << made_of;
  }
  return 0;
}

}  // namespace
}  // namespace dini

int main(int count, char** arguments) {
  if (count == 3) return dini::write_surfaces(arguments[1], std::atoi(arguments[2]));
  std::fprintf(stderr, "usage: write_gltf_surfaces DIRECTORY COUNT\n");
  return 2;
}
