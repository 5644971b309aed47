// GLB files as a whole by the glTF 2.0 specification, and what is left out of them.

#include <limits>

#include "geometry/json.h"
#include "tests/support/glb_parts.h"

using namespace dini;

namespace {

using namespace support;
using json = dini::Json;

TEST_CASE("Vertices count once they are used") {
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

TEST_CASE("Extensions that change no triangle are no reason to refuse, others are") {
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

TEST_CASE("Buffers that nothing needs may be anywhere, those that are read may not") {
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

TEST_CASE("Bytes behind the end, other chunks and padding do no harm, and what is cut short is refused") {
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

TEST_CASE("Points and lines are left out and counted, strips and fans are read") {
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

TEST_CASE("Triangles with a vertex that is not finite are left out, and the place is told") {
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

TEST_CASE("What no mesh can hold is counted") {
  GlbParts parts = triangle_parts();
  parts.document["textures"] = json(2, json::object());
  parts.document["animations"] = json(1, json::object());
  parts.document["cameras"] = json(3, json::object());
  parts.document["meshes"].push_back({{"primitives", json::array()}});
  parts.document["meshes"][0]["weights"] = {0, 0.5};
  for (const char* name : {"TANGENT", "TEXCOORD_1", "_HEAT"}) {
    parts.document["meshes"][0]["primitives"][0]["attributes"][name] = 1;
  }
  parts.document["scenes"][0]["nodes"] = {0, 1};
  parts.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = json::object();
  parts.document["nodes"].push_back({{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  CHECK(read(parts).positions() == triangle_places);
  CHECK(read(parts).warnings ==
        Sentences{"1 hidden node is left out", "1 mesh is left out, since the default scene does not show it",
                  "2 other attributes of vertices are left out", "1 mesh is read without morph targets",
                  "1 node is read once, without the instances of EXT_mesh_gpu_instancing", "2 textures are left out",
                  "1 animation is left out", "3 cameras are left out"});
}

}  // namespace
