// Meshes with skins: they stand where their joints are.

#include <cmath>

#include "geometry/json.h"
#include "tests/support/glb_parts.h"

using namespace dini;

namespace {

using namespace support;
using json = dini::Json;

constexpr std::array<float, 16> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

std::array<float, 16> shift(float x, float y, float z) {
  std::array<float, 16> matrix = identity;
  matrix[12] = x;
  matrix[13] = y;
  matrix[14] = z;
  return matrix;
}

/// A triangle with normals along z that follows the nodes 1 and 2, its own node far away. Each vertex has one weight
/// for each of the two.
GlbParts skinned(const std::array<std::array<float, 2>, 3>& weights) {
  GlbParts parts;
  Bytes joints, shares;
  for (const auto& [first, second] : weights) {
    joints.u8(0).u8(1).u8(0).u8(0);
    shares.f32s({first, second, 0, 0});
  }
  const std::size_t positions = parts.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::size_t normals = parts.positions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  parts.primitive({{"POSITION", positions},
                   {"NORMAL", normals},
                   {"JOINTS_0", parts.accessor("VEC4", gltf_u8, 3, joints)},
                   {"WEIGHTS_0", parts.accessor("VEC4", gltf_f32, 3, shares)}});
  parts.document["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}, {"scale", {0.01, 0.01, 0.01}}},
                             json::object(),
                             json::object()};
  parts.document["scenes"][0]["nodes"] = {0, 1, 2};
  parts.document["skins"] = {{{"joints", {1, 2}}}};
  return parts;
}

void bind(GlbParts& parts, const std::vector<std::array<float, 16>>& matrices) {
  Bytes bytes;
  for (const auto& matrix : matrices) {
    for (const float number : matrix) bytes.f32(number);
  }
  parts.document["skins"][0]["inverseBindMatrices"] = parts.accessor("MAT4", gltf_f32, matrices.size(), bytes);
}

PlaceList places(const GlbParts& parts) { return read(parts).positions(); }

TEST_CASE("A skinned mesh does not stand where its own node is") {
  CHECK(places(skinned({{{1, 0}, {1, 0}, {1, 0}}})) == PlaceList{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  // Only where both the node has a skin and the primitive has joints.
  GlbParts bare = skinned({{{1, 0}, {1, 0}, {1, 0}}});
  bare.document["nodes"][0].erase("skin");
  CHECK(places(bare)[0] == std::array<double, 3>{100, 0, 0});
}

TEST_CASE("A vertex follows its joints from where they were bound, by its weights") {
  GlbParts parts = skinned({{{1, 0}, {0, 1}, {0.5, 0.5}}});
  parts.document["nodes"][1] = {{"translation", {0, 5, 0}}, {"children", {2}}};
  parts.document["nodes"][2] = {{"translation", {0, 0, 7}}};
  parts.document["scenes"][0]["nodes"] = {0, 1};
  CHECK(places(parts) == PlaceList{{0, 5, 0}, {1, 5, 7}, {0, 6, 3.5}});
  bind(parts, {shift(0, -5, 0), shift(0, -5, 0)});
  CHECK(places(parts) == PlaceList{{0, 0, 0}, {1, 0, 7}, {0, 1, 3.5}});
  // Weights are shares of their sum; a vertex without any follows its first joint.
  GlbParts loose = skinned({{{2, 2}, {0, 0}, {0, 0.25}}});
  loose.document["nodes"][2] = {{"translation", {0, 0, 4}}};
  CHECK(places(loose) == PlaceList{{0, 0, 2}, {1, 0, 0}, {0, 1, 4}});
}

TEST_CASE("Joints turn and mirror the normals and triangles that follow them") {
  GlbParts parts = skinned({{{1, 0}, {1, 0}, {1, 0}}});
  parts.document["nodes"][1] = {{"rotation", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}};
  const ReadFile turned = read(parts);
  CHECK(length(turned.mesh.normals[2] - Vector{0, -1, 0}) < 1e-6);
  parts.document["nodes"][1] = {{"scale", {-2, 2, 2}}};
  const ReadFile mirrored = read(parts);
  CHECK(mirrored.positions() == PlaceList{{0, 0, 0}, {-2, 0, 0}, {0, 2, 0}});
  CHECK(mirrored.mesh.normals[0] == Vector{0, 0, 1});
  CHECK(mirrored.mesh.triangles[0] == std::array<std::uint32_t, 3>{0, 2, 1});
}

TEST_CASE("Skins that are wrong are refused") {
  const auto said = [](const std::string& pointer, const json& value) {
    GlbParts parts = skinned({{{1, 0}, {1, 0}, {0, 1}}});
    bind(parts, {identity, identity});
    parts.document[json::json_pointer(pointer)] = value;
    return refusal_of(parts);
  };
  const std::string attributes = "/meshes/0/primitives/0/attributes";
  CHECK(said("/asset/version", "2.0").empty());
  for (const auto& [pointer, value] : std::vector<std::pair<std::string, json>>{{"/nodes/0/skin", 1},
                                                                                {"/skins/0/joints", {1}},
                                                                                {"/skins/0/joints", {1, 9}},
                                                                                {"/skins/0/joints", "all"},
                                                                                {"/skins/0/joints", {1, 2, 0}},
                                                                                {"/skins/0/inverseBindMatrices", 0},
                                                                                {"/skins/0/inverseBindMatrices", 99},
                                                                                {attributes + "/JOINTS_0", 0},
                                                                                {attributes + "/JOINTS_1", 2},
                                                                                {attributes + "/WEIGHTS_0", 1}}) {
    CAPTURE(pointer, value.dump());
    CHECK(said(pointer, value).starts_with("invalid: "));
  }
  GlbParts circle = skinned({{{1, 0}, {1, 0}, {1, 0}}});
  circle.document["nodes"][1]["children"] = {2};
  circle.document["nodes"][2]["children"] = {1};
  circle.document["scenes"][0]["nodes"] = {0};
  CHECK(refusal_of(circle).find("stands above itself") != std::string::npos);
  GlbParts many = skinned({{{1, 0}, {1, 0}, {1, 0}}});
  json& all = many.document["meshes"][0]["primitives"][0]["attributes"];
  for (int set = 1; set < 5; ++set) {
    all["JOINTS_" + std::to_string(set)] = all["JOINTS_0"];
    all["WEIGHTS_" + std::to_string(set)] = all["WEIGHTS_0"];
  }
  CHECK(refusal_of(many).find("more than 16 joints") != std::string::npos);
}

}  // namespace
