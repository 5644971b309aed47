#include "gltf/glb_assembly.h"

#include <catch2/catch.hpp>

#include "gltf/glb_container.h"
#include "gltf/glb_reader.h"
#include "gltf/glb_writer.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

std::string file_of(const Scene& scene) {
  auto encoded = encode_scene(scene, EncodeOptions(), Cancel());
  REQUIRE(encoded);
  return encoded->file;
}

Json json_of(std::string_view glb) {
  const auto chunks = split_glb(glb);
  REQUIRE(chunks);
  return Json::parse(chunks->json);
}

const Mesh& mesh_of_part(const Part& part) { return *std::get<SharedMesh>(part.shape); }

}  // namespace

TEST_CASE("Files that are put together have a node each, with what was in them") {
  const std::string torus = file_of(shapes::scene_of(shapes::torus(20, 12)));
  const std::string field = file_of(shapes::scene_of(shapes::wavy_field(9, 7)));
  const std::vector<GlbItem> items = {{"a", {{"index", 0}}, torus}, {"b", {{"index", 1}}, field}};
  const auto assembled = assemble_glb(items, {{"variants", 2}});
  REQUIRE(assembled);
  const Json document = json_of(*assembled);
  CHECK(document["asset"]["extras"] == Json{{"variants", 2}});
  const Json& roots = document["scenes"][0]["nodes"];
  REQUIRE(roots.size() == 2);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Json& node = document["nodes"][roots[i].get<std::size_t>()];
    CHECK(node["name"] == items[i].name);
    CHECK(node["extras"] == Json{{"index", i}});
    CHECK(node["children"].size() == 1);
  }
  const auto scene = read_glb(*assembled);
  REQUIRE(scene);
  REQUIRE(scene->parts.size() == 2);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto alone = read_glb(items[i].glb);
    REQUIRE(alone);
    const Mesh& mesh = mesh_of_part(scene->parts[i]);
    const Mesh& expected = mesh_of_part(alone->parts.front());
    REQUIRE(mesh.positions.size() == expected.positions.size());
    CHECK(mesh.triangles == expected.triangles);
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
      const Point p = mesh.positions[k], q = expected.positions[k];
      CHECK((p.x == q.x && p.y == q.y && p.z == q.z));
    }
  }
}

TEST_CASE("Items of the same bytes share their meshes") {
  const std::string torus = file_of(shapes::scene_of(shapes::torus(20, 12)));
  const std::vector<GlbItem> items = {{"a", {}, torus}, {"b", {}, torus}, {"c", {}, torus}};
  const auto assembled = assemble_glb(items, {});
  REQUIRE(assembled);
  const Json document = json_of(*assembled);
  CHECK(document["scenes"][0]["nodes"].size() == 3);
  CHECK(document["meshes"].size() == 1);
  CHECK(document["nodes"].size() == 9);
  CHECK(assembled->size() < torus.size() + 2000);
}

TEST_CASE("Several files can stand below one node, each called by its name") {
  const std::string torus = file_of(shapes::scene_of(shapes::torus(20, 12)));
  const std::string field = file_of(shapes::scene_of(shapes::wavy_field(9, 7)));
  std::vector<GlbItem> items;
  for (const std::string name : {"a", "b"}) {
    items.push_back({.name = name,
                     .extras = {{"item", name}},
                     .items = {{.name = "inner", .extras = nullptr, .glb = torus},
                               {.name = "outer", .extras = nullptr, .glb = field}}});
  }
  const auto assembled = assemble_glb(items, {});
  REQUIRE(assembled);
  const Json document = json_of(*assembled);
  CHECK(document["meshes"].size() == 2);
  const Json& roots = document["scenes"][0]["nodes"];
  REQUIRE(roots.size() == 2);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Json& node = document["nodes"][roots[i].get<std::size_t>()];
    CHECK(node["name"] == items[i].name);
    CHECK(node["extras"] == items[i].extras);
    REQUIRE(node["children"].size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const Json& below = document["nodes"][node["children"][k].get<std::size_t>()];
      CHECK(below["name"] == items[i].items[k].name);
      CHECK_FALSE(below.contains("extras"));
      CHECK(below["children"].size() == 1);
    }
  }
  const auto scene = read_glb(*assembled);
  REQUIRE(scene);
  CHECK(scene->parts.size() == 4);
}

TEST_CASE("What is no GLB is not put together") {
  const std::string torus = file_of(shapes::scene_of(shapes::torus(20, 12)));
  for (const std::string& broken :
       {std::string(), std::string("glTF"), torus.substr(0, torus.size() / 2), join_glb("[]", ""), join_glb("{}", ""),
        join_glb(R"({"scenes":[{"nodes":[0]}],"nodes":{},"meshes":3})", ""),
        join_glb(R"({"scenes":[{}],"meshes":[{"primitives":[{"attributes":{"POSITION":"x"}}]}]})", "")}) {
    const std::vector<GlbItem> items = {{"good", {}, torus}, {"broken", {}, broken}};
    CHECK_FALSE(assemble_glb(items, {}));
  }
  CHECK(assemble_glb({}, {}));
}
