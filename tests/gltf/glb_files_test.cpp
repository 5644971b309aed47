// GLB files by the glTF 2.0 specification, and what is left out of them.

#include <algorithm>
#include <cmath>
#include <limits>

#include "gltf/glb_import.h"
#include "tests/support/glb_parts.h"
#include "tests/support/read_file.h"

namespace dini {
namespace {

using namespace support;
using nlohmann::json;
using Places = std::vector<std::array<double, 3>>;
using Colors = std::vector<std::array<float, 4>>;
using Sentences = std::vector<std::string>;

const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const Places triangle_places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

ReadFile read(const GlbParts& parts) { return ReadFile(read_glb_mesh(parts.glb(), {})); }

std::string refusal_of(const GlbParts& parts, const ImportLimits& limits = {}) {
  return refusal(read_glb_mesh, parts.glb(), limits);
}

/// A triangle with normals along z.
GlbParts triangle_parts() {
  GlbParts parts;
  const std::size_t positions = parts.positions(triangle);
  parts.primitive({{"POSITION", positions}, {"NORMAL", parts.positions({0, 0, 1, 0, 0, 1, 0, 0, 1})}});
  return parts;
}

GlbParts triangle_with_material(const json& material) {
  GlbParts parts = triangle_parts();
  parts.document["materials"] = {material};
  parts.document["meshes"][0]["primitives"][0]["material"] = 0;
  return parts;
}

TEST_CASE("alpha counts under BLEND, is compared under MASK, and does not count otherwise") {
  struct Case {
    json material;
    float vertex_alpha, alpha;
  };
  const auto material = [](const char* mode, double alpha, json cutoff) {
    json made = {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, alpha}}}}};
    if (*mode != 0) made["alphaMode"] = mode;
    if (!cutoff.is_null()) made["alphaCutoff"] = cutoff;
    return made;
  };
  for (const auto& [made, vertex_alpha, alpha] : std::vector<Case>{{material("", 0.3, {}), 1, 1},
                                                                   {material("", 0.3, 0.9), 0, 1},
                                                                   {material("OPAQUE", 0, {}), 0.5f, 1},
                                                                   {material("MASK", 0.3, 0.2), 1, 1},
                                                                   {material("MASK", 0.3, {}), 1, 0},
                                                                   {material("MASK", 0.5, {}), 1, 1},
                                                                   {material("MASK", 1, {}), 0.25f, 0},
                                                                   {material("MASK", 1, 2), 1, 0},
                                                                   {material("MASK", 0, 0), 0, 1},
                                                                   {material("BLEND", 0.5, {}), 0.5f, 0.25f}}) {
    CAPTURE(made.dump(), vertex_alpha);
    GlbParts parts = triangle_with_material(made);
    parts.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = parts.accessor(
        "VEC4", gltf_f32, 3, Bytes().f32s({1, 1, 1, vertex_alpha, 1, 1, 1, vertex_alpha, 1, 1, 1, vertex_alpha}));
    const ReadFile file = read(parts);
    CHECK(file.mesh.colors == Colors(3, {0.5f, 0.25f, 1, alpha}));
    CHECK(file.warnings.size() == (alpha == 0 ? 1 : 0));
  }
  CHECK(read(triangle_with_material(material("MASK", 0.1, {}))).warnings ==
        Sentences{"3 vertices lie below the alpha cutoff of their material and become transparent"});
  // White and opaque is no color at all.
  CHECK(read(triangle_with_material({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}}))
            .mesh.colors.empty());
  CHECK(refusal_of(triangle_with_material({{"alphaMode", "GLASS"}})).find("alphaMode") != std::string::npos);
  const json older = {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {0.5, 0, 0, 1}}}}}}};
  CHECK(read(triangle_with_material(older)).mesh.colors == Colors(3, {0.5f, 0, 0, 1}));
}

/// The corners of a unit cube, and its twelve triangles facing outward.
const std::vector<float> cube = {0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};
const std::vector<std::uint32_t> cube_triangles = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                                   2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};

Bytes bytes_of(const std::vector<std::uint32_t>& indices) {
  Bytes bytes;
  for (const std::uint32_t index : indices) bytes.u8(index);
  return bytes;
}

GlbParts cube_parts() {
  GlbParts parts;
  const std::size_t positions = parts.positions(cube);
  parts.primitive({{"POSITION", positions}})["indices"] =
      parts.accessor("SCALAR", gltf_u8, 36, bytes_of(cube_triangles));
  return parts;
}

/// Every normal is that of the planes of the triangles around its vertex.
void check_flat(const Mesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector p = to_vector(mesh.positions[a]);
    const Vector plane = normalized(cross(to_vector(mesh.positions[b]) - p, to_vector(mesh.positions[c]) - p));
    for (const std::uint32_t vertex : {a, b, c}) CHECK(length(mesh.normals[vertex] - plane) < 2e-6);
  }
}

TEST_CASE("a primitive without normals comes out flat, its neighbors with normals as they are") {
  const ReadFile alone = read(cube_parts());
  CHECK(alone.mesh.positions.size() == 24);
  CHECK(alone.mesh.triangles.size() == 12);
  CHECK(alone.warnings.empty());
  check_flat(alone.mesh);
  GlbParts both = cube_parts();
  const std::size_t positions = both.positions(triangle);
  both.primitive({{"POSITION", positions}, {"NORMAL", both.positions({1, 0, 0, 0, 1, 0, 0, 0, 2})}});
  both.document["nodes"][0]["scale"] = {-1, 2, 1};  // it mirrors
  const ReadFile file = read(both);
  REQUIRE(file.mesh.positions.size() == 27);
  CHECK(file.mesh.normals[24] == Vector{-1, 0, 0});
  CHECK(file.mesh.normals[25] == Vector{0, 1, 0});
  Mesh flat = file.mesh;
  flat.triangles.resize(12);
  check_flat(flat);
}

TEST_CASE("where flat normals need more vertices than the limit, they are smooth, and that is told") {
  const ImportResult result = read_glb_mesh(cube_parts().glb(), {23, 12});
  const ReadFile file(result);
  CHECK(file.mesh.positions.size() == 8);
  CHECK(length(file.mesh.normals[7] - normalized(Vector{1, 1, 1})) < 1e-12);
  CHECK(file.warnings == Sentences{"12 triangles without normals get smooth ones, since flat ones need more vertices "
                                   "than the limit"});
}

TEST_CASE("vertices count once they are used") {
  GlbParts parts;
  std::vector<float> many;
  for (int i = 0; i < 50'000; ++i) many.insert(many.end(), {static_cast<float>(i), 0, static_cast<float>(i % 2)});
  const std::size_t positions = parts.positions(many);
  for (std::uint32_t k = 0; k < 25; ++k) {
    const std::uint32_t first = 1999 * k;
    Bytes indices;
    indices.u32(first).u32(first + 2).u32(first + 1);
    parts.primitive({{"POSITION", positions}})["indices"] = parts.accessor("SCALAR", gltf_u32, 3, indices);
  }
  const ReadFile file(read_glb_mesh(parts.glb(), {75, 25}));
  CHECK(file.mesh.positions.size() == 75);
  CHECK(file.mesh.positions[3] == Point{1999, 0, 1});
  CHECK(refusal_of(parts, {74, 25}) == "too large: the file has more than 74 vertices, which is the limit");
  CHECK(refusal_of(parts, {75, 24}).starts_with("too large: "));
}

TEST_CASE("extensions that change no triangle are no reason to refuse, others are") {
  for (const char* name : {"KHR_texture_transform",
                           "KHR_texture_basisu",
                           "EXT_texture_webp",
                           "EXT_texture_avif",
                           "MSFT_texture_dds",
                           "KHR_lights_punctual",
                           "EXT_lights_image_based",
                           "EXT_lights_ies",
                           "KHR_animation_pointer",
                           "KHR_materials_variants",
                           "KHR_materials_unlit",
                           "KHR_materials_pbrSpecularGlossiness",
                           "ADOBE_materials_thin_transparency",
                           "KHR_xmp_json_ld",
                           "KHR_xmp",
                           "EXT_structural_metadata",
                           "EXT_mesh_features",
                           "FB_geometry_metadata",
                           "MSFT_packing_normalRoughnessMetallic",
                           "KHR_techniques_webgl",
                           "KHR_audio_emitter",
                           "KHR_node_visibility",
                           "KHR_node_selectability",
                           "KHR_mesh_quantization",
                           "MSFT_lod"}) {
    CAPTURE(name);
    GlbParts parts = triangle_parts();
    parts.document["extensionsUsed"] = parts.document["extensionsRequired"] = {name};
    CHECK(read(parts).positions() == triangle_places);
  }
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
                           "EXT_mesh_gpu_instancing", "CESIUM_RTC", "MPEG_accessor_timed", "ACME_everything", ""}) {
    CAPTURE(name);
    GlbParts parts = triangle_parts();
    parts.document["extensionsUsed"] = {name};
    CHECK(refusal_of(parts).empty());
    parts.document["extensionsRequired"] = {name};
    CHECK(refusal_of(parts).find(name) != std::string::npos);
  }
  for (const json& wrong : {json("KHR_texture_transform"), json::array({1})}) {
    GlbParts parts = triangle_parts();
    parts.document["extensionsRequired"] = wrong;
    CHECK(refusal_of(parts).starts_with("invalid: "));
  }
}

TEST_CASE("Draco and meshopt are passed over where plain values stand beside them") {
  GlbParts draco = triangle_parts();
  json& primitive = draco.document["meshes"][0]["primitives"][0];
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  CHECK(read(draco).positions() == triangle_places);
  draco.document["accessors"][1].erase("bufferView");
  CHECK(refusal_of(draco) ==
        "invalid: mesh 0, primitive 0: it is compressed with KHR_draco_mesh_compression, which is not "
        "unpacked here; export it without compression");
  GlbParts meshopt = triangle_parts();
  meshopt.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  CHECK(read(meshopt).positions() == triangle_places);
  meshopt.document["buffers"].push_back(
      {{"byteLength", 36}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  meshopt.document["bufferViews"][0]["buffer"] = 1;
  CHECK(refusal_of(meshopt).find("compressed with EXT_meshopt_compression") != std::string::npos);
}

TEST_CASE("buffers that nothing needs may be anywhere, those that are read may not") {
  for (const char* uri : {"data:application/octet-stream;base64,AAAA", "https://example.org/far.bin", ""}) {
    CAPTURE(uri);
    GlbParts parts = triangle_parts();
    parts.document["buffers"].push_back({{"byteLength", 36}, {"uri", uri}});
    parts.document["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 36}});
    CHECK(read(parts).positions() == triangle_places);
    parts.document["bufferViews"][0]["buffer"] = 1;
    CHECK(refusal_of(parts) ==
          "invalid: mesh 0, primitive 0: accessor 0: its buffer has a URI; only the binary chunk of "
          "the file itself is read");
  }
}

TEST_CASE("bytes behind the end, other chunks and padding do no harm; what is cut short is refused") {
  const std::string glb = triangle_parts().glb();
  for (const std::string& behind : {std::string("\n"), std::string(1000, '\0'), std::string("glTF")}) {
    const ReadFile file(read_glb_mesh(glb + behind, {}));
    CHECK(file.positions() == triangle_places);
    const std::string end = behind.size() == 1 ? " byte behind the end of the file is left out"
                                               : " bytes behind the end of the file are left out";
    CHECK(file.warnings == Sentences{std::to_string(behind.size()) + end});
  }
  const auto grown = [&](const std::string& more) {
    const auto size = static_cast<std::uint32_t>(glb.size() + more.size());
    return glb.substr(0, 8) + Bytes().u32(size).text + glb.substr(12) + more;
  };
  CHECK(refusal(read_glb_mesh, grown(Bytes().u32(4).text + "ABCDxxxx")).empty());
  CHECK(refusal(read_glb_mesh, grown(std::string(3, '\0'))).empty());
  CHECK_FALSE(refusal(read_glb_mesh, glb.substr(0, glb.size() - 1)).empty());
  CHECK_FALSE(refusal(read_glb_mesh, glb.substr(0, 8) + Bytes().u32(11).text + glb.substr(12)).empty());
}

TEST_CASE("an accessor without a view is zeros, some of which sparse values replace") {
  GlbParts parts = triangle_parts();
  parts.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = parts.accessor("VEC2", gltf_f32, 3);
  CHECK(read(parts).mesh.uvs == std::vector<std::array<double, 2>>(3, {0, 0}));
  const std::size_t colors = parts.accessor("VEC3", gltf_u8, 3, {}, true);
  parts.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colors;
  CHECK(read(parts).mesh.colors == Colors(3, {0, 0, 0, 1}));
  const std::size_t places = parts.view(Bytes().u16(0).u16(2)),
                    values = parts.view(Bytes().u8(255).u8(0).u8(0).u8(0).u8(255).u8(0));
  parts.document["accessors"][colors]["sparse"] = {{"count", 2},
                                                   {"indices", {{"bufferView", places}, {"componentType", gltf_u16}}},
                                                   {"values", {{"bufferView", values}}}};
  CHECK(read(parts).mesh.colors == Colors{{1, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}});
  const std::size_t moved = parts.view(Bytes().f32s({5, 6, 7}));
  parts.document["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", places}, {"byteOffset", 2}, {"componentType", gltf_u16}}},
      {"values", {{"bufferView", moved}}}};
  CHECK(read(parts).positions() == Places{{0, 0, 0}, {1, 0, 0}, {5, 6, 7}});
}

TEST_CASE("sparse values that are wrong are refused") {
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

TEST_CASE("whole numbers of every type stand for shares of 1 where they say so, and colors always") {
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
  CHECK(file.positions() == Places{{0, 0, 0}, {2, 0, 0}, {0, -2, 0}});
  CHECK(file.mesh.normals[0] == Vector{0, 0, 1});
  CHECK(file.mesh.normals[1] == Vector{0, 0, -1});
  CHECK(file.mesh.normals[2] == Vector{0, 1, 0});
  CHECK(file.mesh.uvs == std::vector<std::array<double, 2>>{{0, 1}, {0.2, 0}, {0, 0}});
  CHECK(file.mesh.colors == Colors{{1, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0.2f, 1}});
  parts.document["accessors"][positions]["normalized"] = false;
  CHECK(read(parts).positions() == Places{{0, 0, 0}, {65534, 0, 0}, {0, -65536, 0}});
}

TEST_CASE("points and lines are left out and counted, strips and fans are read") {
  GlbParts parts = triangle_parts();
  for (const int mode : {0, 1, 2, 3}) parts.primitive({{"POSITION", 0}})["mode"] = mode;
  const ReadFile file = read(parts);
  CHECK(file.positions() == triangle_places);
  CHECK(file.warnings == Sentences{"4 primitives of points or lines are left out"});
  GlbParts strip;
  const std::size_t corners = strip.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  json& primitive = strip.primitive({{"POSITION", corners}});
  primitive["mode"] = 5;
  const auto joined = [&] { return read(strip).triangles(); };
  REQUIRE(joined().size() == 3);
  CHECK(joined()[1] == std::array<std::array<double, 3>, 3>{{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  primitive["indices"] = strip.accessor("SCALAR", gltf_u8, 8, bytes_of({0, 1, 2, 2, 1, 1, 3, 2}));
  CHECK(joined().size() == 2);
  CHECK(read(strip).warnings.empty());
  primitive["mode"] = 6;
  primitive.erase("indices");
  CHECK(joined()[2] == std::array<std::array<double, 3>, 3>{{{0, 0, 0}, {1, 1, 0}, {0, 2, 0}}});
}

TEST_CASE("triangles with a vertex that is not finite are left out, and the place is told") {
  GlbParts parts;
  const std::size_t positions =
      parts.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 1e30f, 0, 0});
  json& primitive = parts.primitive({{"POSITION", positions}});
  primitive["indices"] = parts.accessor("SCALAR", gltf_u8, 12, bytes_of({0, 1, 2, 1, 2, 4, 1, 2, 3, 0, 0, 1}));
  const ReadFile file = read(parts);
  CHECK(file.positions() == triangle_places);
  CHECK(file.warnings ==
        Sentences{"2 faces use a vertex that is not finite or beyond 1e18 and are left out, the first at "
                  "mesh 0, primitive 0, vertex 4",
                  "1 triangle uses a vertex twice and is left out"});
}

TEST_CASE("what no mesh can hold is counted") {
  GlbParts parts = triangle_parts();
  parts.document["textures"] = json(2, json::object());
  parts.document["animations"] = json(1, json::object());
  parts.document["cameras"] = json(3, json::object());
  parts.document["meshes"].push_back({{"primitives", json::array()}});
  parts.document["meshes"][0]["weights"] = {0, 0.5};
  parts.document["scenes"][0]["nodes"] = {0, 1};
  parts.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = json::object();
  parts.document["nodes"].push_back({{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  CHECK(read(parts).positions() == triangle_places);
  CHECK(read(parts).warnings ==
        Sentences{"1 hidden node is left out", "1 mesh is left out, since the default scene does not show it",
                  "1 mesh is read without morph targets",
                  "1 node is read once, without the instances of EXT_mesh_gpu_instancing", "2 textures are left out",
                  "1 animation is left out", "3 cameras are left out"});
}

TEST_CASE("a few bytes cannot ask for the memory or the time of millions of values") {
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
}  // namespace dini
