// Writes one GLB of every kind, and beside it what libdraco decodes from it, for tools/check_glb.mjs:
//   write_gltf_samples DIRECTORY

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "geometry/json.h"
#include "gltf/glb_assembly.h"
#include "gltf/glb_reader.h"
#include "gltf/glb_writer.h"
#include "tests/gltf/shapes.h"

namespace dini {
namespace {

Json to_json(const Part& part) {
  Json result = {{"name", part.name}};
  const auto* mesh = std::get_if<SharedMesh>(&part.shape);
  if (mesh == nullptr) return result;
  for (std::size_t i = 0; i < (*mesh)->positions.size(); ++i) {
    const Point p = (*mesh)->positions[i];
    for (const double value : {p.x, p.y, p.z}) result["positions"].push_back(value);
  }
  for (std::size_t i = 0; i < (*mesh)->normals.size(); ++i) {
    const Vector n = (*mesh)->normals[i];
    for (const double value : {n.x, n.y, n.z}) result["normals"].push_back(value);
  }
  for (const auto& triangle : (*mesh)->triangles) {
    for (const std::uint32_t index : triangle) result["indices"].push_back(index);
  }
  return result;
}

Part mesh_part(const char* name, Mesh mesh) { return {name, std::make_shared<const Mesh>(std::move(mesh)), {}}; }

// A torus without the part above z = 0.2, whose vertices have gone to infinity.
Mesh clipped_torus() {
  Mesh mesh = shapes::torus(60, 40);
  const auto is_cut = [&](std::uint32_t vertex) { return !(mesh.positions[vertex].z < 0.2); };
  std::erase_if(mesh.triangles.edit(), [&](const auto& t) { return is_cut(t[0]) || is_cut(t[1]) || is_cut(t[2]); });
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    if (is_cut(i)) mesh.positions.set(i, Point::at_infinity());
  }
  return mesh;
}

Mesh colored_field() {
  Mesh mesh = shapes::wavy_field(30, 40);
  for (const auto& [u, v] : mesh.uvs) mesh.colors.push_back({static_cast<float>(u), static_cast<float>(v), 0.5f, 0.9f});
  return mesh;
}

std::vector<Polyline> rings(std::size_t count) {
  std::vector<Polyline> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(shapes::circle(24, 1, 0.1 * static_cast<double>(i)));
  result[0].closed = false;
  result.back().points.set(5, Point::at_infinity());
  return result;
}

Column<Point> dots() {
  Column<Point> points(30);
  for (std::size_t i = 0; i < points.size(); ++i) points.set(i, {0.1 * static_cast<double>(i), 1.0 / 3, -2});
  return points;
}

class SampleWriter {
 public:
  explicit SampleWriter(std::filesystem::path directory) : directory_(std::move(directory)) {
    std::filesystem::create_directories(directory_);
  }

  void write(const std::string& name, const Scene& scene, const EncodeOptions& options = {}) {
    EncodeOptions stamped = options;
    stamped.extras = {{"sample", name}, {"parameters", {{"width", 0.1}}}};
    const auto result = encode_scene(scene, stamped, Cancel());
    if (!result) return fail(name + ": " + result.error().detail);
    const EncodedScene& encoded = *result;
    const std::string& glb = encoded.file;
    Json expected = {{"vertices", encoded.vertices}, {"triangles", encoded.triangles}, {"parts", Json::array()}};
    if (options.draco) {
      const auto decoded = read_glb(glb);
      if (!decoded) return fail(name + ": cannot be read back");
      for (const Part& part : decoded->parts) expected["parts"].push_back(to_json(part));
    }
    std::ofstream(directory_ / (name + ".glb"), std::ios::binary) << glb;
    std::ofstream(directory_ / (name + ".expected.json")) << expected;
  }

  /// Two files that were written before, and both of them again below one node, in one.
  void assemble(const std::string& name, const std::string& a, const std::string& b) {
    const std::string files[] = {read(a), read(b)};
    const std::vector<GlbItem> items = {
        {a, {{"index", 0}}, files[0], {}},
        {b, {{"index", 1}}, files[1], {}},
        {"both", {{"index", 2}}, {}, {{a, nullptr, files[0], {}}, {b, nullptr, files[1], {}}}}};
    const auto glb = assemble_glb(items, {{"sample", name}});
    if (!glb) return fail(name + ": cannot be put together");
    std::ofstream(directory_ / (name + ".glb"), std::ios::binary) << *glb;
  }

  bool failed() const { return failed_; }

 private:
  std::string read(const std::string& name) const {
    std::ifstream file(directory_ / (name + ".glb"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void fail(const std::string& message) {
    std::fprintf(stderr, "%s\n", message.c_str());
    failed_ = true;
  }

  std::filesystem::path directory_;
  bool failed_ = false;
};

int write_samples(const char* directory) {
  SampleWriter writer(directory);
  writer.write("torus", shapes::scene_of(shapes::torus(64, 32)));
  writer.write("triangle", shapes::scene_of(shapes::single_triangle()));
  writer.write("clipped", shapes::scene_of(clipped_torus()));
  writer.write("colored", shapes::scene_of(colored_field()));
  writer.write("non_manifold", shapes::scene_of(shapes::random_soup(2, 200, 3000, 5, 1)));
  EncodeOptions options;
  for (const int speed : {0, 3, 5, 9, 10}) {
    options.speed = speed;
    writer.write("speed_" + std::to_string(speed), shapes::scene_of(shapes::random_soup(4, 500, 900, 2, 0)), options);
  }
  options = {};
  options.position_bits = 20;
  writer.write("fine_and_tiny", shapes::scene_of(shapes::random_soup(6, 500, 900, 3e-7, 1e-7)), options);
  Mesh tiled = shapes::torus(240, 240);
  shapes::cut_into_square_tiles(tiled, 240, 240, 100);
  writer.write("tiled", shapes::scene_of(std::move(tiled)));
  Scene scene;
  scene.parts.push_back({"few rings", rings(5), {1, 0, 0, 1}});
  scene.parts.push_back({"many rings", rings(100), {0, 1, 0, 0.5}});
  scene.parts.push_back({"dots", std::make_shared<const Column<Point>>(dots()), {0, 0, 1, 1}});
  writer.write("lines_and_points", scene);
  scene.parts.push_back(mesh_part("torus", shapes::torus(20, 10)));
  scene.parts.push_back(mesh_part("empty", Mesh{}));
  scene.parts.push_back(mesh_part("Flügel \"π\"", shapes::wavy_field(10, 10)));
  writer.write("parts", scene);
  writer.assemble("assembled", "parts", "tiled");
  options = {};
  options.draco = false;
  scene.parts.push_back(mesh_part("colored", colored_field()));
  scene.parts.push_back(mesh_part("many vertices", shapes::torus(300, 300)));
  writer.write("plain", scene, options);
  return writer.failed() ? 1 : 0;
}

}  // namespace
}  // namespace dini

int main(int count, char** arguments) {
  if (count == 2) return dini::write_samples(arguments[1]);
  std::fprintf(stderr, "usage: write_gltf_samples DIRECTORY\n");
  return 2;
}
