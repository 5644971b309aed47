#include "gltf/glb_import.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "geometry/json.h"
#include "geometry/validate.h"
#include "tests/support/damage.h"
#include "tests/support/import_bytes.h"

using namespace dini;

namespace {

using namespace support;
using json = dini::Json;

Mesh checked_mesh(const json& document, const std::string& binary = quad_binary()) {
  const ImportResult result = read_glb_mesh(glb_of(document.dump(), binary), {});
  if (!result) FAIL(result.error().detail);
  const Mesh& mesh = result->mesh;
  CHECK_FALSE(mesh_defect(mesh));
  return mesh;
}

std::string refusal_of(const json& document, const std::string& binary = quad_binary()) {
  return refusal(read_glb_mesh, glb_of(document.dump(), binary));
}

/// The quad's document with the value at a JSON pointer replaced or added.
json changed(const std::string& pointer, json value) {
  json document = quad_document();
  document[json::json_pointer(pointer)] = std::move(value);
  return document;
}

TEST_CASE("A GLB keeps its texture coordinates and colors, and gets the normals it lacks") {
  const Mesh mesh = checked_mesh(quad_document());
  REQUIRE(mesh.positions.size() == 4);
  CHECK(mesh.positions[2] == Point{1, 0, -1});
  CHECK(mesh.uvs == std::vector<std::array<double, 2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(mesh.colors[2] == std::array<float, 4>{0, 0, 1, 1});
  CHECK(mesh.colors[3][0] == Approx(0.2));
  CHECK(length(mesh.normals[0] - Vector{0, 1, 0}) < 1e-12);
  CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("Nodes move, turn and mirror what they hold, and meshes are repeated") {
  json document = quad_document();
  document["scenes"][0]["nodes"] = {0, 2};
  document["nodes"] = {{{"mesh", 0}, {"translation", {10, 0, 0}}, {"children", {1}}},
                       {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"scale", {2, 2, 2}}},
                       {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}}};
  const Mesh mesh = checked_mesh(document);
  REQUIRE(mesh.positions.size() == 12);
  CHECK(mesh.positions[1] == Point{11, 0, 0});
  CHECK(length(to_vector(mesh.positions[5]) - Vector{10, 2, 0}) < 1e-12);
  CHECK(mesh.positions[9] == Point{-1, 0, 5});
  // A mirrored square still faces up.
  CHECK(length(mesh.normals[8] - Vector{0, 1, 0}) < 1e-12);
  CHECK(mesh.triangles[4] == std::array<std::uint32_t, 3>{8, 10, 9});
}

TEST_CASE("Strips, fans, triangles without indices, and the material's color are understood") {
  const std::string primitive = "/meshes/0/primitives/0";
  CHECK(checked_mesh(changed(primitive + "/mode", 6)).triangles.size() == 2);  // two of the four use a vertex twice
  json document = changed(primitive + "/mode", 5);
  document["meshes"][0]["primitives"][0].erase("indices");
  CHECK(checked_mesh(document).triangles.size() == 2);
  document = changed("/materials", json::parse(R"([{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 1, 1]}}])"));
  document["meshes"][0]["primitives"][0]["material"] = 0;
  CHECK(checked_mesh(document).colors[1] == std::array<float, 4>{0, 0.5, 0, 1});
  document = quad_document();
  document["scenes"] = json::array();
  CHECK(checked_mesh(document).positions.size() == 4);
  document = changed("/meshes/0/primitives", json::parse(R"([{"mode": 1, "attributes": {"POSITION": 0}}])"));
  CHECK(refusal_of(document) == "invalid: the file has no triangles; 1 primitive of points or lines is left out");
}

TEST_CASE("What leads out of the file, or needs a decoder, is refused") {
  for (const char* uri :
       {"data:application/octet-stream;base64,AAAA", "/etc/passwd", "http://localhost/", "$(id)", ""}) {
    CAPTURE(uri);
    CHECK(refusal_of(changed("/buffers/0/uri", uri)).find("URI") != std::string::npos);
  }
  CHECK(refusal_of(changed("/extensionsRequired", {"KHR_draco_mesh_compression"})).find("KHR_draco") !=
        std::string::npos);
  json packed = changed("/meshes/0/primitives/0/extensions", {{"KHR_draco_mesh_compression", json::object()}});
  packed["accessors"][3].erase("bufferView");
  CHECK(refusal_of(packed).find("KHR_draco") != std::string::npos);
  CHECK(refusal_of(changed("/extensionsRequired", {"EXT_meshopt_compression"})).find("meshopt") != std::string::npos);
  CHECK(refusal_of(changed("/extensionsRequired", {"KHR_materials_unlit"})).empty());
  CHECK(refusal_of(changed("/accessors/0/sparse", json::object())) ==
        "invalid: mesh 0, primitive 0: accessor 0: \"count\" is missing");
}

TEST_CASE("Documents that are wrong anywhere are refused") {
  const double large = 1e300;
  for (const auto& [pointer, value] : std::vector<std::pair<std::string, json>>{
           {"/accessors/0/count", 5},
           {"/accessors/0/count", 0},
           {"/accessors/0/count", -1},
           {"/accessors/0/count", 1.5},
           {"/accessors/0/count", std::numeric_limits<std::uint64_t>::max()},
           {"/accessors/0/count", 4'000'000'000u},
           {"/accessors/0/count", "4"},
           {"/accessors/0/count", json::array()},
           {"/accessors/0/byteOffset", 1},
           {"/accessors/0/byteOffset", std::numeric_limits<std::uint64_t>::max()},
           {"/accessors/0/componentType", 5124},
           {"/accessors/0/type", "MAT4"},
           {"/accessors/0/type", "VEC2"},
           {"/accessors/0/type", 3},
           {"/accessors/0/bufferView", 4},
           {"/accessors/0", 7},
           {"/accessors", 7},
           {"/accessors/1/count", 3},
           {"/accessors/3/count", 5},
           {"/accessors/3/count", 7},
           {"/accessors/3/componentType", 5126},
           {"/bufferViews/0/byteLength", std::numeric_limits<std::uint64_t>::max()},
           {"/bufferViews/0/byteOffset", 109},
           {"/bufferViews/0/byteStride", 0},
           {"/bufferViews/0/byteStride", 8},
           {"/bufferViews/0/byteStride", std::numeric_limits<std::uint64_t>::max()},
           {"/bufferViews/0/buffer", 1},
           {"/meshes/0/primitives", json::object()},
           {"/meshes/0/primitives/0", nullptr},
           {"/meshes/0/primitives/0/mode", 7},
           {"/meshes/0/primitives/0/attributes", json::object()},
           {"/meshes/0/primitives/0/attributes/POSITION", 3},
           {"/meshes/0/primitives/0/indices", 0},
           {"/meshes/0/primitives/0/material", 0},
           {"/nodes/0/mesh", 1},
           {"/nodes/0/children", {0}},
           {"/nodes/0/children", {7}},
           {"/nodes/0/translation", {1, 2}},
           {"/nodes/0/translation", {large, large, large}},
           {"/nodes/0/scale", {large, large, large}},
           {"/nodes/0/matrix", {1, 2, 3}},
           {"/scenes/0/nodes", {0, 0}},
           {"/scenes/0/nodes", {-1}},
           {"/scene", 1},
           {"/nodes", "none"}}) {
    CAPTURE(pointer, value.dump());
    const std::string refusal = refusal_of(changed(pointer, value));
    CHECK((refusal.starts_with("invalid: ") || refusal.starts_with("too large: ")));
  }
}

TEST_CASE("Indices out of range are refused, and so are files of nothing but numbers that are not finite") {
  std::string binary = quad_binary();
  binary[96] = 4;
  CHECK(refusal_of(quad_document(), binary) == "invalid: mesh 0, primitive 0: an index is 4, but there are 4 vertices");
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    binary = quad_binary();
    binary.replace(0, 4, Bytes().f32(bad).text);
    CHECK(
        refusal_of(quad_document(), binary) ==
        "invalid: the file has no triangles; 2 faces use a vertex that is not finite or beyond 1e18 and are left out, "
        "the first at mesh 0, primitive 0, vertex 0");
    binary = quad_binary();
    binary.replace(48, 4, Bytes().f32(bad).text);
    const Mesh mesh = checked_mesh(quad_document(), binary);
    CHECK(mesh.uvs[0] == std::array<double, 2>{0, 0});
    CHECK(mesh.uvs[1] == std::array<double, 2>{1, 0});
  }
}

TEST_CASE("JSON that is deep, large or none is refused before it is built") {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  CHECK(refusal(read_glb_mesh, glb_of(deep, "")).find("deeper") != std::string::npos);
  CHECK(refusal(read_glb_mesh, glb_of("{\"a\":[" + std::string(600'000, ','), "")).find("values") != std::string::npos);
  CHECK(refusal(read_glb_mesh, glb_of(std::string(5 << 20, ' '), "")).find("4 MiB") != std::string::npos);
  for (const std::string text : {"", "{", "[]", "null", "{}", "{\"a\":\"\\", "\"{"}) {
    CAPTURE(text);
    CHECK(refusal(read_glb_mesh, glb_of(text, "")).starts_with("invalid: "));
  }
}

TEST_CASE("A small file cannot ask for endless work") {
  json document = quad_document();
  document["scenes"][0].erase("nodes");
  document["meshes"][0]["primitives"] = json(2000, {{"mode", 0}});
  document["nodes"] = json(2000, {{"mesh", 0}});
  document.erase("scenes");
  CHECK(refusal_of(document).starts_with("too large: "));
  document = quad_document();
  document["nodes"] = json(1000, {{"mesh", 0}});
  document.erase("scenes");
  const std::string glb = glb_of(document.dump(), quad_binary());
  CHECK(refusal(read_glb_mesh, glb).empty());
  CHECK(refusal(read_glb_mesh, glb, {3999, 2000}).starts_with("too large: "));
  CHECK(refusal(read_glb_mesh, glb, {4000, 1999}).starts_with("too large: "));
}

TEST_CASE("A GLB is left when the work is to stop") {
  Cancel told;
  told.stop(StopReason::deadline);
  CHECK(refusal(read_glb_mesh, quad_glb(), {}, told) == "stopped");
}

TEST_CASE("Triangles that use a vertex twice are counted, and not against the limit") {
  json document = quad_document();
  document["accessors"][3] = {{"bufferView", 3}, {"componentType", 5121}, {"count", 3000}, {"type", "SCALAR"}};
  document["bufferViews"][3]["byteLength"] = 3000;
  document["buffers"][0]["byteLength"] = 3096;
  const std::string glb = glb_of(document.dump(), quad_binary().substr(0, 96) + std::string(3000, '\0'));
  CHECK(refusal(read_glb_mesh, glb, {100, 900}) ==
        "invalid: the file has no triangles; 1000 triangles use a vertex twice and are left out");
}

TEST_CASE("A GLB cut short at any byte, or with any byte changed, is read or refused and nothing worse") {
  const std::string good = quad_glb();
  CHECK(refusal(read_glb_mesh, good).empty());
  for (std::size_t size = 0; size < good.size(); ++size) {
    CHECK_FALSE(refusal(read_glb_mesh, std::string_view(good).substr(0, size)).empty());
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char change : {'\0', '9', '\xff'}) {
      std::string bytes = good;
      bytes[at] = change;
      refusal(read_glb_mesh, bytes);
    }
  }
}

TEST_CASE("A GLB with damage of any kind is read or refused, and nothing worse") {
  std::mt19937 random(11);
  const std::string text = quad_document().dump();
  for (int i = 0; i < 6000; ++i) {
    // Either chunk alone, so that the container holds.
    check_is_read_or_refused(read_glb_mesh, glb_of(i % 3 == 0 ? text : damaged(text, random),
                                                   i % 3 != 0 ? quad_binary() : damaged(quad_binary(), random)));
  }
}

/// All places of a document, the document itself first.
void collect(json& place, std::vector<json*>& places) {
  places.push_back(&place);
  if (!place.is_structured()) return;
  for (json& child : place) collect(child, places);
}

TEST_CASE("A GLB whose members have changed places or values is read or refused, and nothing worse") {
  std::mt19937 random(13);
  const std::vector<json> values = {0,
                                    1,
                                    3,
                                    5,
                                    255,
                                    -1,
                                    0.5,
                                    4294967295u,
                                    std::numeric_limits<std::uint64_t>::max(),
                                    1e300,
                                    5120,
                                    5121,
                                    5123,
                                    5125,
                                    5126,
                                    "VEC3",
                                    "VEC4",
                                    "SCALAR",
                                    "MAT4",
                                    nullptr,
                                    true,
                                    json::array(),
                                    json::object()};
  for (int i = 0; i < 6000; ++i) {
    json document = quad_document();
    std::vector<json*> places;
    collect(document, places);
    json& place = *places[random() % places.size()];
    const json other = *places[random() % places.size()];
    place = random() % 2 == 0 ? other : values[random() % values.size()];
    check_is_read_or_refused(read_glb_mesh, glb_of(document.dump(), quad_binary()));
  }
}

}  // namespace
