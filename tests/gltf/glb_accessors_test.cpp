// Accessors of GLB files: without data, sparse, of whole numbers, and asking for too much.

#include "geometry/json.h"
#include "tests/support/glb_parts.h"

using namespace dini;

namespace {

using namespace support;
using json = dini::Json;

TEST_CASE("An accessor without a view is zeros, some of which sparse values replace") {
  GlbParts parts = triangle_parts();
  parts.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = parts.accessor("VEC2", gltf_f32, 3);
  CHECK(read(parts).mesh.uvs == std::vector<std::array<double, 2>>(3, {0, 0}));
  const std::size_t colors = parts.accessor("VEC3", gltf_u8, 3, {}, true);
  parts.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colors;
  CHECK(read(parts).mesh.colors == ColorList(3, {0, 0, 0, 1}));
  const std::size_t places = parts.view(Bytes().u16(0).u16(2)),
                    values = parts.view(Bytes().u8(255).u8(0).u8(0).u8(0).u8(255).u8(0));
  parts.document["accessors"][colors]["sparse"] = {{"count", 2},
                                                   {"indices", {{"bufferView", places}, {"componentType", gltf_u16}}},
                                                   {"values", {{"bufferView", values}}}};
  CHECK(read(parts).mesh.colors == ColorList{{1, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}});
  const std::size_t moved = parts.view(Bytes().f32s({5, 6, 7}));
  parts.document["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", places}, {"byteOffset", 2}, {"componentType", gltf_u16}}},
      {"values", {{"bufferView", moved}}}};
  CHECK(read(parts).positions() == PlaceList{{0, 0, 0}, {1, 0, 0}, {5, 6, 7}});
}

TEST_CASE("Sparse values that are wrong are refused") {
  const json good = {
      {"count", 2}, {"indices", {{"bufferView", 2}, {"componentType", gltf_u8}}}, {"values", {{"bufferView", 3}}}};
  const auto said = [&](const std::string& pointer, const json& value, std::uint32_t first = 0,
                        std::uint32_t second = 1) {
    GlbParts parts = triangle_parts();
    parts.view(Bytes().u8(first).u8(second));
    parts.view(Bytes().f32s({0, 0, 0, 2, 0, 0}));
    parts.document["accessors"][0]["sparse"] = good;
    if (!pointer.empty()) parts.document["accessors"][0]["sparse"][json::json_pointer(pointer)] = value;
    return refusal_of(parts);
  };
  CHECK(said("", {}).empty());
  CHECK(said("", {}, 1, 1).find("do not ascend") != std::string::npos);
  CHECK(said("", {}, 1, 0).find("do not ascend") != std::string::npos);
  CHECK(said("", {}, 0, 3).find("do not ascend") != std::string::npos);
  for (const auto& [pointer, value] : std::vector<std::pair<std::string, json>>{{"/count", 0},
                                                                                {"/count", 4},
                                                                                {"/count", -1},
                                                                                {"/count", 1e15},
                                                                                {"/indices", 7},
                                                                                {"/values", json::object()},
                                                                                {"/indices/bufferView", 9},
                                                                                {"/indices/componentType", gltf_f32},
                                                                                {"/indices/componentType", gltf_u32},
                                                                                {"/indices/byteOffset", 1},
                                                                                {"/values/bufferView", 2},
                                                                                {"/values/byteOffset", 4}}) {
    CAPTURE(pointer, value.dump());
    CHECK(said(pointer, value).starts_with("invalid: mesh 0, primitive 0: accessor 0: "));
  }
}

TEST_CASE("Whole numbers of every type stand for shares of 1 where they say so, and colors always") {
  GlbParts parts;
  parts.document["nodes"][0]["scale"] = {2, 2, 2};
  const std::size_t positions = parts.accessor(
      "VEC3", gltf_i16, 3, Bytes().u16(0).u16(0).u16(0).u16(32767).u16(0).u16(0).u16(0).u16(0x8000).u16(0), true);
  const std::size_t normals =
      parts.accessor("VEC3", gltf_i8, 3, Bytes().u8(0).u8(0).u8(127).u8(0).u8(0).u8(0x80).u8(0).u8(64).u8(0), true);
  const std::size_t uvs =
      parts.accessor("VEC2", gltf_u16, 3, Bytes().u16(0).u16(65535).u16(13107).u16(0).u16(0).u16(0), true);
  const std::size_t colors = parts.accessor(
      "VEC3", gltf_u16, 3, Bytes().u16(65535).u16(0).u16(0).u16(0).u16(0).u16(0).u16(0).u16(0).u16(13107));
  parts.primitive({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}, {"COLOR_0", colors}});
  const ReadFile file = read(parts);
  CHECK(file.positions() == PlaceList{{0, 0, 0}, {2, 0, 0}, {0, -2, 0}});
  CHECK(file.mesh.normals[0] == Vector{0, 0, 1});
  CHECK(file.mesh.normals[1] == Vector{0, 0, -1});
  CHECK(file.mesh.normals[2] == Vector{0, 1, 0});
  CHECK(file.mesh.uvs == std::vector<std::array<double, 2>>{{0, 1}, {0.2, 0}, {0, 0}});
  CHECK(file.mesh.colors == ColorList{{1, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0.2f, 1}});
  parts.document["accessors"][positions]["normalized"] = false;
  CHECK(read(parts).positions() == PlaceList{{0, 0, 0}, {65534, 0, 0}, {0, -65536, 0}});
}

TEST_CASE("A few bytes cannot ask for the memory or the time of millions of values") {
  // Three hundred bytes ask for thousands of millions of vertices, corners and sparse values.
  const std::size_t many = 4'000'000'000;
  GlbParts zeros;
  const std::size_t positions = zeros.accessor("VEC3", gltf_f32, many);
  zeros.primitive({{"POSITION", positions}})["mode"] = 5;
  CHECK(refusal_of(zeros) == "too large: the file asks for the same values again and again");
  zeros.document["accessors"][0]["count"] = 3'000'000;
  CHECK(refusal_of(zeros) ==
        "invalid: the file has no triangles; 2999998 triangles have no area, since their positions do "
        "not stand in the file, and are left out");
  GlbParts corners = triangle_parts();
  corners.document["meshes"][0]["primitives"][0]["indices"] = corners.accessor("SCALAR", gltf_u32, many * 3);
  CHECK(refusal_of(corners) == "too large: the file asks for the same values again and again");
  GlbParts repeated = triangle_parts();
  repeated.document["meshes"][0]["primitives"] = json(
      1000,
      {{"attributes", {{"POSITION", 0}}},
       {"indices", repeated.accessor("SCALAR", gltf_u8, 300'000, bytes_of(std::vector<std::uint32_t>(300'000, 0)))}});
  CHECK(refusal_of(repeated) == "too large: the file asks for the same values again and again");
}

}  // namespace
