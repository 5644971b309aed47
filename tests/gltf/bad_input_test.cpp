#include <catch2/catch.hpp>
#include <limits>

#include "gltf/draco_encoder.h"
#include "tests/gltf/compare.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

using namespace compare;
using Code = EncodeError::Code;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Scene torus_with_vertex(const Point& point) {
  Mesh mesh = shapes::torus(20, 10);
  mesh.positions.set(57, point);
  return shapes::scene_of(std::move(mesh));
}

TEST_CASE("Positions that are not finite are refused with part and vertex") {
  const double bad = GENERATE(values<double>({not_a_number, infinity, -infinity}));
  const int speed = GENERATE(1, 7, 10);
  CAPTURE(bad, speed);
  EncodeOptions options;
  options.speed = speed;
  for (const Point& point : {Point{bad, 0, 0}, Point{0, bad, 0}, Point{0, 0, bad}}) {
    const EncodeError error = failure(torus_with_vertex(point), options);
    CHECK(error.code == Code::non_finite);
    CHECK(error.part == "mesh");
    CHECK(error.detail.find("57") != std::string::npos);
  }
}

TEST_CASE("Positions that overflow are refused") {
  const double bad = GENERATE(1e300, -1e300, 1e39, 1e18, std::numeric_limits<double>::max());
  CHECK(failure(torus_with_vertex({0, bad, 0})).code == Code::too_large);
}

TEST_CASE("Extreme but allowed extents are written") {
  const double large = GENERATE(9.9e17, 1e10, 1e-10, 1e-38, 1e-45, 1e-320, 0.0);
  const int speed = GENERATE(0, 3, 7, 10);
  CAPTURE(large, speed);
  Mesh mesh = shapes::torus(20, 10);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions.set(i, to_point(0.7 * large * to_vector(mesh.positions[i])));
  }
  const Scene scene = shapes::scene_of(std::move(mesh));
  EncodeOptions options;
  options.speed = speed;
  const Scene decoded = decode(encode(scene, options).file);
  CHECK(same_positions(rounded_triangles(mesh_of(scene), grid_of(scene, 14)), stored_triangles(mesh_of(decoded))));
}

TEST_CASE("Vertices that no triangle uses neither fail nor widen the grid") {
  Mesh mesh = shapes::single_triangle();
  mesh.positions = Column<Point>(5);
  mesh.positions.set(1, {1, 0, 0});
  mesh.positions.set(2, {0, 1, 0});
  mesh.positions.set(3, Point::at_infinity());
  mesh.positions.set(4, {1e12, 0, 0});
  mesh.triangles.push_back({3, 3, 4});
  const EncodedScene encoded = encode(shapes::scene_of(std::move(mesh)));
  CHECK(encoded.vertices == 3);
  CHECK(encoded.triangles == 1);
  CHECK(encoded.position_error < 1e-4);
}

TEST_CASE("An index out of range is refused") {
  Mesh mesh = shapes::torus(20, 10);
  mesh.triangles.edit()[8][1] = 200;
  CHECK(failure(shapes::scene_of(mesh)).code == Code::invalid_input);
  mesh.triangles.edit()[8][1] = std::numeric_limits<std::uint32_t>::max();
  CHECK(failure(shapes::scene_of(mesh)).code == Code::invalid_input);
}

TEST_CASE("Meshes that break their contract are refused") {
  Mesh mesh = shapes::torus(20, 10);
  SECTION("normals") { mesh.normals = Column<Vector>(199); }
  SECTION("texture coordinates") { mesh.uvs.resize(201); }
  SECTION("colors") { mesh.colors.resize(1); }
  SECTION("tiles that stop early") { mesh.tile_ends.edit() = {100}; }
  SECTION("tiles out of order") { mesh.tile_ends.edit() = {300, 100, 400}; }
  CHECK(failure(shapes::scene_of(mesh)).code == Code::invalid_input);
}

TEST_CASE("Options out of range are refused") {
  EncodeOptions options;
  SECTION("coarse") { options.position_bits = 7; }
  SECTION("fine") { options.position_bits = 21; }
  SECTION("normals") { options.normal_bits = 1; }
  SECTION("speed") { options.speed = 11; }
  CHECK(failure(shapes::scene_of(shapes::torus(20, 10)), options).code == Code::invalid_input);
}

TEST_CASE("A scene with nothing to draw is the error empty") {
  Mesh degenerate = shapes::single_triangle();
  degenerate.triangles.edit() = {{0, 0, 1}, {1, 2, 1}, {2, 2, 2}};
  CHECK(failure(Scene{}).code == Code::empty);
  CHECK(failure(shapes::scene_of(Mesh{})).code == Code::empty);
  CHECK(failure(shapes::scene_of(degenerate)).code == Code::empty);
  Scene scene;
  scene.parts.push_back({"lines", std::vector<Polyline>{}, {}});
  scene.parts.push_back({"points", SharedColumn<Point>(), {}});
  scene.parts.push_back({"nothing", SharedMesh(), {}});
  CHECK(failure(scene).code == Code::empty);
}

TEST_CASE("An empty part is left out and named") {
  Scene scene = shapes::scene_of(shapes::torus(20, 10));
  scene.parts.push_back({"gone", std::make_shared<const Mesh>(), {}});
  const EncodedScene encoded = encode(scene);
  CHECK(encoded.empty_parts == std::vector<std::string>{"gone"});
  CHECK(decode(encoded.file).parts.size() == 1);
}

TEST_CASE("Normals without a direction become a unit vector") {
  Mesh mesh = shapes::torus(20, 10);
  const Vector bad = GENERATE(Vector{0, 0, 0}, Vector{not_a_number, 0, 1}, Vector{infinity, 0, 0}, Vector{1e-300, 0, 0},
                              Vector{1e300, 1e300, -1e300});
  for (std::size_t i = 0; i < mesh.normals.size(); i += 3) mesh.normals.set(i, bad);
  const Scene decoded = decode(encode(shapes::scene_of(std::move(mesh))).file);
  for (std::size_t i = 0; i < mesh_of(decoded).normals.size(); ++i) {
    CHECK(length(mesh_of(decoded).normals[i]) == Approx(1).margin(1e-6));
  }
}

TEST_CASE("Texture coordinates that are not finite are refused, colors are clamped") {
  Mesh mesh = shapes::random_soup(5, 30, 60, 1, 0);
  for (auto& color : mesh.colors.edit()) color = {-5, std::numeric_limits<float>::quiet_NaN(), 1e30f, 1};
  const Scene decoded = decode(encode(shapes::scene_of(mesh)).file);
  CHECK(mesh_of(decoded).colors[0] == std::array<float, 4>{0, 0, 1, 1});
  mesh.uvs.edit()[mesh.triangles[0][0]] = {not_a_number, 0};
  CHECK(failure(shapes::scene_of(mesh)).code == Code::non_finite);
}

TEST_CASE("The smallest and the strangest meshes are written") {
  const int speed = GENERATE(0, 5, 7, 9, 10);
  CAPTURE(speed);
  EncodeOptions options;
  options.speed = speed;
  Mesh mesh = shapes::single_triangle();
  SECTION("one triangle") {}
  SECTION("one triangle twice") { mesh.triangles.push_back({0, 1, 2}); }
  SECTION("two sides") { mesh.triangles.push_back({0, 2, 1}); }
  SECTION("all points equal") { mesh.positions = Column<Point>(3); }
  SECTION("flat along every axis but one") { mesh.positions.set(2, {2, 0, 0}); }
  SECTION("three triangles on one edge") {
    mesh.positions = Column<Point>(5);
    for (std::size_t i = 0; i < 5; ++i)
      mesh.positions.set(i, {static_cast<double>(i % 2), 1.0 * static_cast<double>(i), 0});
    mesh.triangles.edit() = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  }
  const Scene scene = shapes::scene_of(mesh);
  const EncodedScene encoded = encode(scene, options);
  const Scene decoded = decode(encoded.file);
  CHECK(encoded.vertices == mesh_of(decoded).positions.size());
  CHECK(same_positions(rounded_triangles(mesh, grid_of(scene, 14)), stored_triangles(mesh_of(decoded))));
}

TEST_CASE("Thousands of small random meshes come back at every speed") {
  const int speed = GENERATE(range(0, 11));
  CAPTURE(speed);
  EncodeOptions options;
  options.speed = speed;
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    Mesh mesh = shapes::random_soup(seed, 3 + seed % 9, 1 + seed % 23, 2, 0);
    // Every third mesh has vertices on top of each other.
    for (std::size_t i = 1; seed % 3 == 0 && i < mesh.positions.size(); i += 2)
      mesh.positions.set(i, mesh.positions[0]);
    const Scene scene = shapes::scene_of(std::move(mesh));
    const auto expected = rounded_triangles(mesh_of(scene), grid_of(scene, 14));
    if (expected.empty()) continue;
    const EncodedScene encoded = encode(scene, options);
    const Scene decoded = decode(encoded.file);
    REQUIRE(encoded.vertices == mesh_of(decoded).positions.size());
    REQUIRE(encoded.triangles == expected.size());
    REQUIRE(same_positions(expected, stored_triangles(mesh_of(decoded))));
  }
}

TEST_CASE("An encoder that fails becomes an error with the name of the part") {
  class Broken final : public MeshEncoder {
   public:
    EncodeResult<EncodedTile> encode(const Tile&, const TileGrids&, const EncodeOptions&) const override {
      return EncodeError{Code::encoder_failed, "broken", ""};
    }
  };
  const auto result = encode_scene(shapes::scene_of(shapes::torus(20, 10)), {}, Cancel(), Broken());
  REQUIRE_FALSE(result);
  CHECK(result.error().part == "mesh");
  CHECK(result.error().detail == "broken");
  const auto empty = DracoEncoder().encode({}, {}, {});
  CHECK(empty.error().code == Code::empty);
}

TEST_CASE("A part name that is not UTF-8 is an error, not a crash") {
  Scene scene = shapes::scene_of(shapes::torus(20, 10));
  scene.parts[0].name = "\xff\xfe";
  CHECK(failure(scene).code == Code::encoder_failed);
}

}  // namespace
