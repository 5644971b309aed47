#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "geometry/json.h"
#include "gltf/glb_import.h"
#include "tests/gltf/compare.h"
#include "tests/gltf/shapes.h"
#include "tests/support/picture_value.h"

using namespace dini;

namespace {

using namespace compare;

// The largest distance per axis between the vertices of `mesh` and their rounding.
double largest_error(const Mesh& mesh, const QuantizationGrid& grid) {
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const double original = mesh.positions.component(axis)[i];
      const double decoded = static_cast<double>(grid.decoded(axis, static_cast<float>(original)));
      largest = std::max(largest, std::abs(decoded - original));
    }
  }
  return largest;
}

TEST_CASE("Random meshes come back on the grid and within the announced bound") {
  const double extent = GENERATE(1e-6, 1.0, 3000.0, 1e14);
  const double offset = GENERATE(0.0, 0.3, 1e3);
  const int bits = GENERATE(8, 14, 20);
  CAPTURE(extent, offset, bits);
  const Scene scene = shapes::scene_of(shapes::random_soup(7, 60, 200, extent, offset * extent));
  EncodeOptions options;
  options.position_bits = bits;
  const EncodedScene encoded = encode(scene, options);
  const QuantizationGrid grid = grid_of(scene, bits);
  CHECK(encoded.position_error == grid.position_error());
  CHECK(largest_error(mesh_of(scene), grid) <= encoded.position_error);
  const Scene decoded = decode(encoded.file);
  CHECK(same_positions(rounded_triangles(mesh_of(scene), grid), stored_triangles(mesh_of(decoded))));
}

TEST_CASE("Every speed keeps triangles, winding, normals and counts") {
  const int speed = GENERATE(range(0, 11));
  const bool manifold = GENERATE(true, false);
  CAPTURE(speed, manifold);
  const Scene scene = shapes::scene_of(manifold ? shapes::torus(40, 30) : shapes::random_soup(3, 200, 1500, 2.0, 0.0));
  EncodeOptions options;
  options.speed = speed;
  const EncodedScene encoded = encode(scene, options);
  const Scene decoded = decode(encoded.file);
  const auto expected = rounded_triangles(mesh_of(scene), grid_of(scene, options.position_bits));
  const auto actual = stored_triangles(mesh_of(decoded));
  CHECK(same_positions(expected, actual));
  CHECK(encoded.triangles == actual.size());
  CHECK(encoded.vertices == mesh_of(decoded).positions.size());
  CHECK(largest_normal_angle(expected, actual) <= encoded.attribute_errors.normal);
}

TEST_CASE("Normals stay within the announced angle") {
  const int bits = GENERATE(6, 8, 10, 12, 16);
  CAPTURE(bits);
  const Scene scene = shapes::scene_of(shapes::random_soup(11, 20000, 30000, 2.0, 0.0));
  EncodeOptions options;
  options.normal_bits = bits;
  options.position_bits = 20;
  const EncodedScene encoded = encode(scene, options);
  const auto expected = rounded_triangles(mesh_of(scene), grid_of(scene, 20));
  const double angle = largest_normal_angle(expected, stored_triangles(mesh_of(decode(encoded.file))));
  CHECK(angle <= encoded.attribute_errors.normal);
  CHECK(angle > encoded.attribute_errors.normal / 2);
}

TEST_CASE("Accessor bounds are those of the decoded positions, bit for bit") {
  const double offset = GENERATE(0.0, -0.37, 12.5);
  const int bits = GENERATE(8, 11, 14, 17, 20);
  CAPTURE(offset, bits);
  Scene scene;
  for (unsigned part = 0; part < 4; ++part) {
    auto mesh = shapes::random_soup(part, 50, 200, 1.7 + part, offset * (part + 1));
    scene.parts.push_back({"part", std::make_shared<const Mesh>(std::move(mesh)), {}});
  }
  EncodeOptions options;
  options.position_bits = bits;
  const EncodedScene encoded = encode(scene, options);
  const Scene decoded = decode(encoded.file);
  const auto document = dini::Json::parse(split_glb(encoded.file)->json);
  for (std::size_t part = 0; part < scene.parts.size(); ++part) {
    const auto& primitive = document["meshes"][part]["primitives"][0];
    const auto& accessor = document["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const Mesh& mesh = mesh_of(decoded, part);
    CHECK(accessor["count"] == mesh.positions.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* values = mesh.positions.component(axis);
      const auto [minimum, maximum] = std::minmax_element(values, values + mesh.positions.size());
      CHECK(accessor["min"][axis].get<double>() == *minimum);
      CHECK(accessor["max"][axis].get<double>() == *maximum);
    }
  }
}

TEST_CASE("Texture coordinates and colors come back") {
  Mesh mesh = shapes::wavy_field(20, 30);
  for (const auto& [u, v] : mesh.uvs) mesh.colors.push_back({static_cast<float>(u), static_cast<float>(v), 1, 1});
  const int speed = GENERATE(1, 3, 5, 7, 9, 10);
  CAPTURE(speed);
  EncodeOptions options;
  options.speed = speed;
  const Scene decoded = decode(encode(shapes::scene_of(mesh), options).file);
  const Mesh& back = mesh_of(decoded);
  REQUIRE(back.uvs.size() == back.positions.size());
  REQUIRE(back.colors.size() == back.positions.size());
  for (std::size_t i = 0; i < back.positions.size(); ++i) {
    const Point p = back.positions[i];
    CHECK(back.uvs[i][0] == Approx(p.x / 2).margin(3e-4));
    CHECK(back.uvs[i][1] == Approx(p.y / 2).margin(3e-4));
    CHECK(static_cast<double>(back.colors[i][0]) == Approx(p.x / 2).margin(2e-4));
    CHECK(back.colors[i][2] == 1);
  }
}

TEST_CASE("Every color of a picture comes back, the darkest ones too") {
  Mesh mesh = shapes::wavy_field(16, 16);
  REQUIRE(mesh.positions.size() == 256);
  for (int value = 0; value < 256; ++value) {
    const double share = value / 255.0;
    const auto linear = static_cast<float>(share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
    mesh.colors.push_back({linear, linear, linear, 1});
  }
  const int speed = GENERATE(1, 7, 10);
  EncodeOptions options;
  options.speed = speed;
  const Scene decoded = decode(encode(shapes::scene_of(mesh), options).file);
  std::set<int> found;
  for (const auto& color : mesh_of(decoded).colors) {
    found.insert(support::picture_value(static_cast<double>(color[0])));
    CHECK(color[3] == 1);
  }
  CHECK(found.size() == 256);
  CHECK(*found.begin() == 0);
  CHECK(*found.rbegin() == 255);
}

TEST_CASE("Texture coordinates that reach far are reported with what rounding costs them") {
  Mesh mesh = shapes::wavy_field(20, 30);
  CHECK(encode(shapes::scene_of(mesh), {}).rough_uvs.empty());
  mesh.uvs.edit()[5] = {-1000, 2};
  const EncodedScene encoded = encode(shapes::scene_of(mesh), {});
  REQUIRE(encoded.rough_uvs.size() == 1);
  const RoughUvs& rough = encoded.rough_uvs[0];
  CHECK(rough.part == "mesh");
  CHECK(rough.minimum == -1000);
  CHECK(rough.maximum == 2);
  CHECK(rough.error == Approx(1001.0 / 4095 / 2).epsilon(0.01));
  const Scene decoded = decode(encoded.file);
  const Mesh& back = mesh_of(decoded);
  double worst = 0;
  for (std::size_t i = 0; i < back.uvs.size(); ++i) {
    if (back.uvs[i][0] > -999) worst = std::max(worst, std::abs(back.uvs[i][0] - back.positions[i].x / 2));
  }
  CHECK(worst < rough.error);
  CHECK(worst > rough.error / 10);
}

TEST_CASE("Texture coordinates and colors stay within the announced bounds") {
  const int bits = GENERATE(8, 12, 20);
  CAPTURE(bits);
  Mesh mesh = shapes::wavy_field(40, 30);
  for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
    const auto share = static_cast<float>(mesh.uvs[i][0]);
    mesh.colors.edit().push_back({share, share, share, 1});
  }
  EncodeOptions options;
  options.uv_bits = bits;
  options.position_bits = 20;
  const EncodedScene encoded = encode(shapes::scene_of(mesh), options);
  const Scene decoded = decode(encoded.file);
  const Mesh& back = mesh_of(decoded);
  double uv = 0, color = 0;
  for (std::size_t i = 0; i < back.uvs.size(); ++i) {
    const double share = back.positions[i].x / 2;  // as the original has it, but for the rounding of positions
    uv = std::max(uv, std::abs(back.uvs[i][0] - share));
    color = std::max(color, std::abs(static_cast<double>(back.colors[i][0]) - share));
  }
  CHECK(uv <= encoded.attribute_errors.uv + encoded.position_error);
  CHECK(color <= encoded.attribute_errors.color + encoded.position_error);
  if (bits < 20) CHECK(uv > encoded.attribute_errors.uv / 4);
  CHECK(color > encoded.attribute_errors.color / 4);
}

TEST_CASE("Attributes that were not asked for are not written") {
  EncodeOptions options;
  options.normals = options.uvs = options.colors = false;
  const EncodedScene encoded = encode(shapes::scene_of(shapes::random_soup(1, 30, 60, 1, 0)), options);
  const Scene decoded = decode(encoded.file);
  CHECK(mesh_of(decoded).normals.empty());
  CHECK(mesh_of(decoded).uvs.empty());
  CHECK(mesh_of(decoded).colors.empty());
  CHECK(encoded.attribute_errors.normal == 0);
}

TEST_CASE("Without Draco a mesh is one primitive of the very floats, which needs no extension") {
  Mesh mesh = shapes::torus(240, 240);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.colors.push_back({0.5f, 1, 0, 0.25f});
  const Scene scene = shapes::scene_of(std::move(mesh));
  EncodeOptions options;
  options.draco = false;
  options.position_bits = 8;
  const EncodedScene encoded = encode(scene, options);
  const auto gltf = dini::Json::parse(split_glb(encoded.file)->json);
  CHECK_FALSE(gltf.contains("extensionsUsed"));
  CHECK(gltf["meshes"][0]["primitives"].size() == 1);
  CHECK(gltf["materials"][0]["alphaMode"] == "BLEND");
  const auto read = read_glb_mesh(encoded.file, {});
  REQUIRE(read);
  const Mesh& original = mesh_of(scene);
  CHECK(read->mesh.triangles.size() == original.triangles.size());
  CHECK(read->mesh.positions.size() == original.positions.size());
  CHECK(encoded.vertices == original.positions.size());
  CHECK(encoded.triangles == original.triangles.size());
  CHECK(read->mesh.colors[0][3] == Approx(0.25).margin(1e-4));
  double largest = 0;
  for (std::size_t i = 0; i < original.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      // An import has the axes of the file, in which y is up.
      const Vector there = to_vector(read->mesh.positions[read->mesh.triangles[i][corner]]);
      const Vector here = to_vector(original.positions[original.triangles[i][corner]]);
      const Vector apart = Vector{there.x, -there.z, there.y} - here;
      largest = std::max({largest, std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)});
    }
  }
  CHECK(largest <= encoded.position_error);
  CHECK(encoded.position_error < 1e-7);
}

TEST_CASE("Parts keep their names, colors and order") {
  Scene scene;
  for (const char* name : {"hull", "deck"}) {
    Mesh mesh = shapes::torus(12, 8);
    mesh.color = {0.25, 0.5, 1, name[0] == 'h' ? 1.0 : 0.5};
    scene.parts.push_back({name, std::make_shared<const Mesh>(std::move(mesh)), {}});
  }
  scene.parts.push_back({"rings", std::vector<Polyline>{shapes::circle(8, 1, 0)}, {1, 0, 0, 1}});
  const Scene decoded = decode(encode(scene).file);
  REQUIRE(decoded.parts.size() == 3);
  CHECK(decoded.parts[0].name == "hull");
  CHECK(mesh_of(decoded, 0).color == Color{0.25, 0.5, 1, 1});
  CHECK(decoded.parts[1].name == "deck");
  CHECK(mesh_of(decoded, 1).color == Color{0.25, 0.5, 1, 0.5});
  CHECK(decoded.parts[2].name == "rings");
  CHECK(decoded.parts[2].color == Color{1, 0, 0, 1});
}

TEST_CASE("One root node turns Z up into Y up") {
  const auto document = dini::Json::parse(split_glb(encode(shapes::scene_of(shapes::torus(8, 6))).file)->json);
  CHECK(document["scenes"][0]["nodes"] == dini::Json::array({0}));
  const auto rotation = document["nodes"][0]["rotation"].get<std::array<double, 4>>();
  CHECK(rotation[0] == Approx(-std::sqrt(0.5)));
  CHECK(rotation[3] == Approx(std::sqrt(0.5)));
  CHECK(document["extensionsRequired"] == dini::Json::array({"KHR_draco_mesh_compression"}));
}

}  // namespace
