// Documents with groups on the command line.

#include "tests/cli/graph_folder.h"
#include "tests/cli/real_program.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Two balls of one group, which holds another one.
Json grouped() {
  return Json::parse(R"({
    "format": 2,
    "groups": {
      "ball": {"inputs": [{"name": "radius"}], "outputs": [{"name": "mesh", "from": "skin"}], "nodes": {
        "skin": {"type": "sphere_mesh", "inputs": {"radius": {"input": "radius"}, "segments": 8, "rings": 4}}}},
      "shifted": {"inputs": [{"name": "by"}, {"name": "radius", "default": 2}], "outputs": [{"name": "mesh", "from": "moved"}], "nodes": {
        "ball": {"type": "group/ball", "inputs": {"radius": {"input": "radius"}}},
        "moved": {"type": "translate", "inputs": {"shape": {"from": "ball"}, "vector": {"input": "by"}}}}}
    },
    "nodes": {
      "a": {"type": "group/shifted", "inputs": {"by": [1, 0, 0]}},
      "b": {"type": "group/shifted", "inputs": {"by": [-1, 0, 0], "radius": 1}},
      "out": {"type": "export", "inputs": {"model": [{"from": "a"}, {"from": "b.mesh"}]}}
    }
  })");
}

Json flat() {
  const auto ball = [](double radius) {
    return make("sphere_mesh", {{"radius", radius}, {"segments", 8}, {"rings", 4}});
  };
  const auto moved = [](const char* ball_id, double by) {
    return make("translate", {{"shape", from(ball_id)}, {"vector", {by, 0, 0}}});
  };
  return {{"format", 2},
          {"nodes",
           {{"a/ball/skin", ball(2)},
            {"a/moved", moved("a/ball/skin", 1)},
            {"b/ball/skin", ball(1)},
            {"b/moved", moved("b/ball/skin", -1)},
            {"out", make("export", {{"model", {from("a/moved"), from("b/moved")}}})}}}};
}

}  // namespace

TEST_CASE("A document with nested groups evaluates to the file and the tag of its flat form") {
  const GraphFolder files;
  const std::string with = files.graph("with.json", grouped()), without = files.graph("without.json", flat());
  REQUIRE(run({"eval", with, "-o", files.at("with.glb")}).code == 0);
  REQUIRE(run({"eval", without, "-o", files.at("without.glb")}).code == 0);
  CHECK(files.read("with.glb") == files.read("without.glb"));
  const auto tags = [](const std::string& graph) { return Json::parse(run({"hash", graph, "--json"}).out)["outputs"]; };
  CHECK(tags(with) == tags(without));
}

TEST_CASE("A difference tells inputs of instances at the instance, whatever they are called") {
  const GraphFolder files;
  Json before = grouped(), after;
  before["groups"]["shifted"]["inputs"][1]["name"] = "nodes";
  before["groups"]["shifted"]["nodes"]["ball"]["inputs"]["radius"] = {{"input", "nodes"}};
  before["nodes"]["b"]["inputs"] = {{"by", {-1, 0, 0}}, {"nodes", 1}};
  after = before;
  after["nodes"]["b"]["inputs"]["nodes"] = 3;
  after["groups"]["shifted"]["nodes"]["ball"]["inputs"]["inputs"] = 4;
  after["groups"]["shifted"]["nodes"]["more"] = make("circle");
  const auto told = run({"diff", files.graph("before.json", before), files.graph("after.json", after)});
  CHECK(told.code == 1);
  CHECK(told.out ==
        "+ group shifted/more\n"
        "~ group shifted/ball.inputs: default -> 4\n"
        "~ b.nodes: 1 -> 3\n");
}

TEST_CASE("Fmt gives each node of a group a line, and changes nothing else") {
  const GraphFolder files;
  const std::string file = files.graph("graph.json", grouped());
  CHECK(run({"fmt", file}).code == 0);
  CHECK(Json::parse(files.read("graph.json")) == grouped());
  CHECK(run({"fmt", "--check", file}).code == 0);
  CHECK(files.read("graph.json").find("\n        \"skin\": {\"type\": \"sphere_mesh\", ") != std::string::npos);
}

TEST_CASE("A problem in a group has the line of what was written, and the id of the node") {
  const GraphFolder files;
  Json wrong = grouped();
  wrong["groups"]["shifted"]["nodes"]["ball"]["inputs"]["radius"] = "two";
  const std::string file = files.graph("graph.json", wrong);
  REQUIRE(run({"fmt", file}).code == 0);
  const std::string text = files.read("graph.json");
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("\"two\"")), '\n');
  const Outcome outcome = run({"validate", file});
  CHECK(outcome.code == 3);
  CHECK(outcome.err.find("graph.json:" + std::to_string(line) + ":") != std::string::npos);
  CHECK(outcome.err.find("a/ball/skin.radius") != std::string::npos);
  CHECK(outcome.err.find("b/ball/skin.radius") != std::string::npos);
}

TEST_CASE("A difference names nodes of groups behind the group") {
  const GraphFolder files;
  Json after = grouped();
  after["groups"]["ball"]["nodes"]["skin"]["inputs"]["rings"] = 6;
  after["groups"]["ball"]["nodes"]["extra"] = make("circle");
  after["groups"]["shifted"]["label"] = "Shifted ball";
  after["groups"]["more"] = {{"nodes", Json::object()}};
  const std::string before = files.graph("a.json", grouped()), changed = files.graph("b.json", after);
  const Outcome outcome = run({"diff", before, changed});
  CHECK(outcome.code == 1);
  CHECK(outcome.out ==
        "+ group more\n"
        "+ group ball/extra\n"
        "~ group ball/skin.rings: 4 -> 6\n"
        "~ group shifted.label: default -> \"Shifted ball\"\n");
  CHECK(run({"diff", before, before}).code == 0);
}

TEST_CASE("An output in a group is written by its path") {
  const GraphFolder files;
  Json graph = grouped();
  graph["groups"]["shifted"]["nodes"]["file"] = make("export", {{"model", from("moved")}});
  graph["nodes"].erase("out");
  const std::string file = files.graph("graph.json", graph);
  REQUIRE(run({"eval", file, "-o", files.at("{graph}.{output}.glb")}).code == 0);
  CHECK_FALSE(files.read("graph.a-file.glb").empty());
  REQUIRE(run({"eval", file, "-o", "b/file=" + files.at("b.glb")}).code == 0);
  CHECK(files.read("b.glb") == files.read("graph.b-file.glb"));
}
