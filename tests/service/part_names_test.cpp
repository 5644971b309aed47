// Parts and materials of a file are called after the nodes that made them.

#include <catch2/catch.hpp>

#include "gltf/glb_container.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

using Names = std::vector<std::string>;

Json gltf_of(const Engine& engine, const Json& graph, const Json& parameters = Json::object()) {
  const std::string file = file_of(engine, {.graph = graph, .parameters = parameters, .output = ""});
  const auto chunks = split_glb(file);
  REQUIRE(chunks);
  return Json::parse(chunks->json);
}

Names names_of(const Json& objects) {
  Names names;
  for (const Json& object : objects) names.push_back(object["name"]);
  return names;
}

Json ball() { return make("sphere_mesh", {{"segments", 6}, {"rings", 4}}); }

Json out_of(Json models) { return make("export", {{"model", std::move(models)}}); }

}  // namespace

TEST_CASE("Parts, their meshes and their materials have the id of the node that made them") {
  const std::unique_ptr<Engine> engine = make_engine();
  const Json gltf = gltf_of(*engine, document({{"globe", ball()},
                                               {"hoop", make("circle")},
                                               {"spot", make("point")},
                                               {"out", out_of({from("globe"), from("hoop"), from("spot")})}}));
  CHECK(names_of(gltf["meshes"]) == Names{"globe", "hoop", "spot"});
  CHECK(names_of(gltf["nodes"]) == Names{"Z up to Y up", "globe", "hoop", "spot"});
  CHECK(names_of(gltf["materials"]) == Names{"globe", "hoop", "spot"});
}

TEST_CASE("A mesh of a family has its place on each axis beside the id, and shares the material") {
  const std::unique_ptr<Engine> engine = make_engine();
  const Json gltf =
      gltf_of(*engine, document({{"i", make("range", {{"count", 2}, {"to", 3}})},
                                 {"j", make("range", {{"count", 3}, {"to", 9}})},
                                 {"at", make("vector", {{"x", from("i")}, {"y", from("j")}})},
                                 {"globe", ball()},
                                 {"globes", make("translate", {{"shape", from("globe")}, {"vector", from("at")}})},
                                 {"out", out_of(from("globes"))}}));
  CHECK(names_of(gltf["meshes"]) ==
        Names{"globes[0,0]", "globes[0,1]", "globes[0,2]", "globes[1,0]", "globes[1,1]", "globes[1,2]"});
  CHECK(names_of(gltf["materials"]) == Names{"globes"});
}

TEST_CASE("No two parts and no two materials of a file have one name") {
  const std::unique_ptr<Engine> engine = make_engine();
  Json same = make("color", {{"shape", from("globe")}});
  same["bypass"] = true;
  const Json gltf =
      gltf_of(*engine, document({{"globe", ball()},
                                 {"same", same},
                                 {"k", make("range", {{"count", 3}})},
                                 {"row", make("color_by", {{"shape", from("globe")}, {"value", from("k")}})},
                                 {"out", out_of({from("globe"), from("row"), from("same"), from("row")})}}));
  CHECK(names_of(gltf["meshes"]) ==
        Names{"globe", "row[0]", "row[1]", "row[2]", "globe.2", "row.2[0]", "row.2[1]", "row.2[2]"});
  // The cyclic palette is alike at both ends, and what looks alike is one material.
  CHECK(names_of(gltf["materials"]) == Names{"globe", "row", "row[1]"});
}

TEST_CASE("An output that is not a node's first is named too") {
  const std::unique_ptr<Engine> engine = make_engine();
  const Json gltf = gltf_of(*engine, document({{"hoop", make("circle")},
                                               {"ends", make("poles_of", {{"shape", from("hoop")}})},
                                               {"out", out_of({from("ends.a"), from("ends.b")})}}));
  CHECK(names_of(gltf["meshes"]) == Names{"ends", "ends.b"});
}

TEST_CASE("Names come from before bypassed nodes and nodes that only pass on") {
  const std::unique_ptr<Engine> engine = make_engine();
  Json scaled = make("scale", {{"shape", from("globe")}, {"factor", 2}});
  scaled["bypass"] = true;
  Json colored = make("color", {{"shape", from("scaled")}});
  colored["bypass"] = true;
  const Json gltf = gltf_of(*engine, document({{"globe", ball()},
                                               {"scaled", scaled},
                                               {"colored", colored},
                                               {"hoop", make("circle")},
                                               {"one", make("list", {{"items", {from("hoop")}}})},
                                               {"two", make("list", {{"items", {from("hoop"), from("hoop")}}})},
                                               {"out", out_of({from("colored"), from("one"), from("two")})}}));
  CHECK(names_of(gltf["meshes"]) == Names{"globe", "hoop", "two"});
}

TEST_CASE("Names stay when a parameter empties a part or makes another longer") {
  const std::unique_ptr<Engine> engine = make_engine();
  Json graph = document({{"k", make("range", {{"count", {{"parameter", "count"}}}})},
                         {"at", make("vector", {{"x", from("k")}})},
                         {"globe", ball()},
                         {"row", make("translate", {{"shape", from("globe")}, {"vector", from("at")}})},
                         {"torus", make("torus_mesh", {{"center", {{"parameter", "place"}}}, {"segments", 8}})},
                         {"out", out_of({from("row"), from("torus")})}});
  graph["parameters"] = {{"count", {{"type", "integer"}, {"default", 2}, {"min", 1}, {"max", 9}}},
                         {"place", {{"type", "vector"}, {"default", {0, 0, 0}}}}};
  CHECK(names_of(gltf_of(*engine, graph)["meshes"]) == Names{"row[0]", "row[1]", "torus"});
  CHECK(names_of(gltf_of(*engine, graph, {{"count", 3}})["meshes"]) == Names{"row[0]", "row[1]", "row[2]", "torus"});
  // So far away nothing is left of the torus.
  CHECK(names_of(gltf_of(*engine, graph, {{"place", {1e17, 0, 0}}})["meshes"]) == Names{"row[0]", "row[1]"});
}

TEST_CASE("One graph's names never show in another's file, though they share every result") {
  const std::unique_ptr<Engine> engine = make_engine();
  for (const std::string id : {"globe", "marble", "globe"}) {
    CAPTURE(id);
    const Json graph = document({{id, ball()}, {"out", out_of(from(id))}});
    CHECK(names_of(gltf_of(*engine, graph)["meshes"]) == Names{id});
  }
}

TEST_CASE("An export of nothing names the nodes and the parameters to change") {
  const std::unique_ptr<Engine> engine = make_engine();
  Json graph = document(
      {{"globe", make("sphere_mesh", {{"center", {{"parameter", "place"}}}})}, {"out", out_of(from("globe"))}});
  graph["parameters"] = {{"place", {{"type", "vector"}, {"default", {1e17, 0, 0}}, {"label", "Place"}}}};
  const Result<Answered> answer = answered(*engine, {.graph = graph, .parameters = Json::object(), .output = ""});
  REQUIRE_FALSE(answer);
  const Problem& problem = answer.problems().front();
  CHECK(problem.code == "nothing-to-export");
  CHECK(problem.node == "out");
  CHECK(problem.port == "model");
  CHECK(problem.detail ==
        "there is nothing to draw: globe (Sphere mesh), which depends on the parameter place (Place), has no triangles "
        "that are larger than the round-off at their place; change what they depend on, or their inputs");
}
