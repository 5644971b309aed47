#include "gltf/tiles.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "tests/gltf/compare.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

using namespace compare;

Mesh mesh_with_runs(std::size_t triangles, std::vector<std::size_t> ends) {
  Mesh mesh;
  mesh.triangles.resize(triangles);
  mesh.tile_ends = std::move(ends);
  return mesh;
}

const TileSizes sizes;

TEST_CASE("Where compressing is slow tiles are half as large") {
  CHECK(tile_sizes({.speed = 4}).largest == sizes.largest);
  CHECK(2 * tile_sizes({.speed = 3}).largest == sizes.largest);
}

TEST_CASE("Small meshes stay in one piece and large ones are cut evenly") {
  CHECK(plan_tiles(mesh_with_runs(0, {}), sizes).empty());
  CHECK(plan_tiles(mesh_with_runs(1, {}), sizes) == std::vector<std::size_t>{1});
  CHECK(plan_tiles(mesh_with_runs(sizes.largest, {}), sizes).size() == 1);
  CHECK(plan_tiles(mesh_with_runs(sizes.largest + 1, {}), sizes).size() == 2);
  CHECK(plan_tiles(mesh_with_runs(100 * sizes.usual, {}), sizes).size() == 100);
}

TEST_CASE("Small neighboring runs are joined and long ones cut") {
  CHECK(plan_tiles(mesh_with_runs(40, {10, 20, 30, 40}), sizes) == std::vector<std::size_t>{40});
  CHECK(plan_tiles(mesh_with_runs(80000, {32768, 65536, 80000}), sizes) == std::vector<std::size_t>{65536, 80000});
  const auto ends = plan_tiles(mesh_with_runs(200100, {100, 200100}), sizes);
  CHECK(ends.back() == 200100);
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    CHECK(end > begin);
    CHECK(end - begin <= sizes.largest);
    begin = end;
  }
}

TEST_CASE("A tile keeps its triangles, in a numbering by first use, without unused vertices") {
  Mesh mesh = shapes::wavy_field(5, 5);
  mesh.triangles.edit()[9] = {3, 3, 4};
  const auto built = build_tile(mesh, 8, 12, {}, Cancel());
  REQUIRE(built);
  const Tile& tile = *built;
  REQUIRE(tile.triangles.size() == 3);
  CHECK(tile.triangles[0] == std::array<std::uint32_t, 3>{0, 1, 2});
  std::set<std::uint32_t> used;
  for (const auto& triangle : tile.triangles) used.insert(triangle.begin(), triangle.end());
  CHECK(used.size() == tile.positions.size());
  CHECK(tile.normals.size() == tile.positions.size());
  const Point first = mesh.positions[mesh.triangles[8][0]];
  CHECK(tile.positions[0][0] == static_cast<float>(first.x));
}

TEST_CASE("Tiles together hold every triangle, and no crack opens between them") {
  const bool squares = GENERATE(true, false);
  Mesh mesh = shapes::torus(320, 300);
  if (squares) shapes::cut_into_square_tiles(mesh, 320, 300, 64);
  const Scene scene = shapes::scene_of(std::move(mesh));
  const EncodedScene encoded = encode(scene);
  const Scene decoded = decode(encoded.file);
  REQUIRE(mesh_of(decoded).tile_ends.size() > 3);
  const auto expected = rounded_triangles(mesh_of(scene), grid_of(scene, 14));
  const auto actual = stored_triangles(mesh_of(decoded));
  CHECK(same_positions(expected, actual));
  CHECK(largest_normal_angle(expected, actual) <= encoded.attribute_errors.normal);
  // A closed surface: every edge is met as often in one direction as in the other.
  std::map<std::array<std::array<float, 3>, 2>, int> edges;
  for (const Triangle& triangle : actual) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto& a = triangle[corner].position;
      const auto& b = triangle[(corner + 1) % 3].position;
      if (a < b) ++edges[{a, b}];
      if (b < a) --edges[{b, a}];
    }
  }
  CHECK(std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
}

TEST_CASE("Parts share one grid, so equal vertices of two parts stay equal") {
  Mesh small = shapes::wavy_field(9, 9);
  Mesh large = shapes::wavy_field(9, 9);
  for (std::size_t i = 9; i < 81; ++i) large.positions.set(i, {large.positions[i].x, large.positions[i].y, 7.7});
  Scene scene = shapes::scene_of(std::move(small));
  scene.parts.push_back({"large", std::make_shared<const Mesh>(std::move(large)), {}});
  const QuantizationGrid grid = grid_of(scene, 14);
  const Scene decoded = decode(encode(scene).file);
  for (std::size_t part = 0; part < 2; ++part) {
    CHECK(same_positions(rounded_triangles(mesh_of(scene, part), grid), stored_triangles(mesh_of(decoded, part))));
  }
}

TEST_CASE("The bytes do not depend on the number of threads") {
  Mesh mesh = shapes::wavy_field(400, 400);
  const Scene scene = shapes::scene_of(std::move(mesh));
  std::vector<std::string> files;
  for (const int threads : {1, 2, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
    tbb::task_arena arena(threads);
    arena.execute([&] { files.push_back(encode(scene).file); });
  }
  for (const std::string& file : files) CHECK(file == files[0]);
}

TEST_CASE("A stopped encoding says so") {
  const Scene scene = shapes::scene_of(shapes::wavy_field(50, 50));
  const Cancel cancel;
  cancel.stop(StopReason::client_gone);
  const auto result = encode_scene(scene, {}, cancel);
  REQUIRE_FALSE(result);
  CHECK(result.error().code == EncodeError::Code::canceled);
}

}  // namespace
