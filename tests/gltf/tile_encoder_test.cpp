// The writer of Draco streams against libdraco: the same bytes for the same tile.

#include "gltf/tile_encoder.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "algebra/kernels.h"
#include "draco/tile_topology.h"
#include "gltf/tiles.h"
#include "tests/draco/grids.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

/// Which attributes a tile has besides its positions.
struct Wanted {
  bool normals = true, uvs = true, colors = true;
};

float number(float least, float most, std::mt19937& random) {
  return std::uniform_real_distribution<float>(least, most)(random);
}

/// A tile over these triangles with attributes by chance.
Tile tile_of(const grids::TriangleList& list, const Wanted& wanted, std::mt19937& random) {
  Tile tile;
  tile.triangles = list.triangles;
  const float roughness = number(0, 1, random) < 0.5f ? 1.0f : 0.01f;
  for (std::size_t i = 0; i < list.vertices; ++i) {
    const float along = static_cast<float>(i) / static_cast<float>(list.vertices);
    const auto value = [&] { return along + number(-roughness, roughness, random); };
    tile.positions.push_back({value(), value(), value()});
    tile.position_box.include(tile.positions.back());
    if (wanted.normals) tile.normals.push_back({value() + 0.1f, value() - 0.5f, value() + 1e-3f});
    if (wanted.uvs) {
      tile.uvs.push_back({value(), value()});
      tile.uv_box.include(std::array<float, 3>{tile.uvs.back()[0], tile.uvs.back()[1], 0});
    }
    if (wanted.colors) {
      const auto channel = static_cast<std::uint16_t>(16 * std::lround(4095 * std::min(std::abs(along), 1.0f)));
      tile.colors.push_back({channel, static_cast<std::uint16_t>(random()), 65535, 0});
    }
  }
  return tile;
}

TileGrids grids_of(const Tile& tile, int bits) {
  return {QuantizationGrid(tile.position_box, bits), QuantizationGrid(tile.uv_box, 12)};
}

/// The bytes of the own writer, which must have written them, and of libdraco.
void check_equal(const Tile& tile, const EncodeOptions& options) {
  REQUIRE(tile_topology(tile.triangles, tile.positions.size()) != nullptr);
  const TileGrids grids = grids_of(tile, options.position_bits);
  const auto own = TileEncoder().encode(tile, grids, options);
  const auto reference = DracoEncoder().encode(tile, grids, options);
  REQUIRE(own);
  REQUIRE(reference);
  CHECK(own->bytes == reference->bytes);
  CHECK(own->vertices == reference->vertices);
  CHECK(own->triangles == reference->triangles);
  CHECK(own->position_id == reference->position_id);
  CHECK(own->normal_id == reference->normal_id);
  CHECK(own->uv_id == reference->uv_id);
  CHECK(own->color_id == reference->color_id);
}

TEST_CASE("Smooth surfaces have the bytes that libdraco writes") {
  const Wanted wanted = GENERATE(Wanted{false, false, false}, Wanted{true, false, false}, Wanted{true, true, false},
                                 Wanted{true, true, true});
  EncodeOptions options;
  options.normals = wanted.normals;
  options.uvs = wanted.uvs;
  for (const Mesh& mesh : {shapes::single_triangle(), shapes::wavy_field(3, 3), shapes::wavy_field(10, 7),
                           shapes::torus(8, 5), shapes::torus(40, 30), shapes::wavy_field(129, 129, 5)}) {
    const auto tile = build_tile(mesh, 0, mesh.triangles.size(), options, Cancel());
    REQUIRE(tile);
    check_equal(*tile, options);
  }
}

TEST_CASE("Random grids, tubes and tori, whole and with holes, have the bytes that libdraco writes") {
  std::mt19937 random(7);
  int manifolds = 0;
  for (int i = 0; manifolds < 10000; ++i) {
    const grids::TriangleList list = grids::any(i % 50 == 0 ? 40 : 9, random);
    if (!tile_topology(list.triangles, list.vertices)) continue;
    ++manifolds;
    CAPTURE(i);
    const Tile tile = tile_of(list, {i % 2 == 0, i % 3 == 0, i % 5 == 0}, random);
    EncodeOptions options;
    options.position_bits = 8 + i % 13;
    options.normal_bits = 6 + i % 11;
    check_equal(tile, options);
  }
}

/// A number with any bits, or one that is close to what is special.
float any_number(std::mt19937& random) {
  static constexpr float special[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, -1e-38f, 1e18f, -1e18f, 0.5f, 16777216.0f};
  if (random() % 4 == 0) return special[random() % std::size(special)];
  if (random() % 4 == 0) return number(-1, 1, random);
  const float any = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  return std::isfinite(any) && std::abs(any) <= 1e18f ? any : 0.0f;
}

TEST_CASE("Whatever a tile holds, the own writer and libdraco agree, or both refuse") {
  std::mt19937 random(11);
  int written = 0;
  for (int i = 0; i < 3000; ++i) {
    CAPTURE(i);
    grids::TriangleList list = grids::any(6, random);
    // Some triangles are twisted, repeated, torn off or joined where they do not belong.
    for (auto& triangle : list.triangles) {
      if (random() % 20 == 0) std::swap(triangle[random() % 3], triangle[random() % 3]);
      if (random() % 40 == 0) triangle[random() % 3] = static_cast<std::uint32_t>(random() % list.vertices);
    }
    if (i % 7 == 0) list.triangles.push_back(list.triangles[random() % list.triangles.size()]);
    if (i % 3 == 0) std::shuffle(list.triangles.begin(), list.triangles.end(), random);
    Tile tile = tile_of(list, {i % 2 == 0, i % 3 == 0, i % 5 == 0}, random);
    tile.position_box = {};
    for (auto& position : tile.positions) {
      for (float& value : position) value = any_number(random);
      tile.position_box.include(position);
    }
    for (auto& normal : tile.normals) normal = {any_number(random), any_number(random), any_number(random)};
    EncodeOptions options;
    options.position_bits = 8 + i % 13;
    options.normal_bits = 6 + i % 11;
    const TileGrids grids = grids_of(tile, options.position_bits);
    const auto own = TileEncoder().encode(tile, grids, options);
    const auto reference = DracoEncoder().encode(tile, grids, options);
    REQUIRE(own.has_value() == reference.has_value());
    if (!own) continue;
    ++written;
    CHECK(own->bytes == reference->bytes);
  }
  CHECK(written > 2000);
}

TEST_CASE("Tiles of one point, a line and a plane have the bytes that libdraco writes") {
  std::mt19937 random(8);
  const grids::TriangleList list = grids::grid(6, 6, grids::Wrap::none, random);
  for (const int flat : {1, 2, 3}) {
    Tile tile = tile_of(list, {}, random);
    tile.position_box = {};
    for (auto& position : tile.positions) {
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(flat); ++axis) position[axis] = 0.25f;
      tile.position_box.include(position);
    }
    check_equal(tile, {});
  }
}

TEST_CASE("What is no manifold is left to libdraco") {
  const Mesh soup = shapes::random_soup(9, 60, 200, 2, 0);
  const EncodeOptions options;
  const auto tile = build_tile(soup, 0, soup.triangles.size(), options, Cancel());
  REQUIRE(tile);
  CHECK(tile_topology(tile->triangles, tile->positions.size()) == nullptr);
  const TileGrids grids = grids_of(*tile, 14);
  CHECK(TileEncoder().encode(*tile, grids, options)->bytes == DracoEncoder().encode(*tile, grids, options)->bytes);
}

TEST_CASE("Speeds 8 and 9 give the bytes of 7, others those of libdraco") {
  const Mesh mesh = shapes::torus(20, 15);
  EncodeOptions options;
  const auto tile = build_tile(mesh, 0, mesh.triangles.size(), options, Cancel());
  const TileGrids grids = grids_of(*tile, 14);
  const auto usual = TileEncoder().encode(*tile, grids, options)->bytes;
  for (const int speed : {0, 3, 5, 6, 8, 9, 10}) {
    CAPTURE(speed);
    options.speed = speed;
    const auto own = TileEncoder().encode(*tile, grids, options)->bytes;
    CHECK(own == (speed == 8 || speed == 9 ? usual : DracoEncoder().encode(*tile, grids, options)->bytes));
  }
}

TEST_CASE("Known topologies and instruction sets change no byte") {
  struct Restore {
    ~Restore() { kernels::force_instruction_set(""); }
  } const restore;
  std::mt19937 random(10);
  const Tile tile = tile_of(grids::grid(30, 20, grids::Wrap::both, random), {}, random);
  const TileGrids grids = grids_of(tile, 14);
  const auto plain = TileEncoder().encode(tile, grids, {})->bytes;
  TopologyCache topologies(1 << 24);
  EncodeOptions options;
  options.topologies = &topologies;
  for (const char* name : kernels::instruction_sets()) {
    CAPTURE(name);
    REQUIRE(kernels::force_instruction_set(name));
    CHECK(TileEncoder().encode(tile, grids, options)->bytes == plain);
    CHECK(topologies.size() > 0);
  }
}

}  // namespace
