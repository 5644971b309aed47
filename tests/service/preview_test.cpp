// Previews through the real engine: what is drawn, how it is named, and what is refused.

#include <catch2/catch.hpp>
#include <set>

#include "gltf/glb_container.h"
#include "graph/wire.h"
#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

Asked showing(Json nodes, std::vector<std::string> preview) {
  Asked request;
  request.graph = document(std::move(nodes));
  request.preview = std::move(preview);
  return request;
}

std::string preview_of(const Asked& request) {
  const Result<Answered> answer = answered(engine(), request);
  require_none(answer ? Problems{} : answer.problems());
  REQUIRE(answer->preview);
  return *answer->preview;
}

Json json_of(const std::string& glb) {
  const auto chunks = split_glb(glb);
  REQUIRE(chunks);
  return Json::parse(chunks->json);
}

/// The children of every group by "node.output", with their extras and the modes of their primitives.
std::map<std::string, Json> children_of(const Json& json) {
  std::map<std::string, Json> found;
  for (const Json& group : json["nodes"][0]["children"]) {
    const Json& node = json["nodes"][group.get<std::size_t>()];
    for (const Json& child : node.value("children", Json::array())) {
      Json entry = json["nodes"][child.get<std::size_t>()];
      entry["primitives"] = json["meshes"][entry["mesh"].get<std::size_t>()]["primitives"];
      found[node["name"].get<std::string>() + "." + entry["name"].get<std::string>()] = entry;
    }
  }
  return found;
}

/// The largest coordinate in a file.
double extent_of(const Json& json) {
  double largest = 0;
  for (const Json& accessor : json["accessors"]) {
    for (const char* side : {"min", "max"}) {
      for (const Json& value : accessor.value(side, Json::array())) {
        largest = std::max(largest, std::abs(value.get<double>()));
      }
    }
  }
  return largest;
}

Problems refused(const Asked& request) {
  const auto prepared = prepared_for(engine(), request);
  REQUIRE_FALSE(prepared);
  return prepared.problems();
}

const Json ring_graph = {{"ring", make("circle", {{"radius", 2}})},
                         {"skin", make("tube", {{"shape", from("ring")}, {"radius", 0.1}})},
                         {"out", make("export", {{"model", from("skin")}})}};

/// Every generator that there is a picture for.
const Json generators = {{"null", make("point_pair")},
                         {"real", make("point_pair", {{"split", 0.5}})},
                         {"imaginary", make("point_pair", {{"split", -0.5}})},
                         {"flat", make("flat_point", {{"position", {1, 0, 0}}})},
                         {"slide", make("direction", {{"direction", {1, 1, 0}}})},
                         {"line", make("line")},
                         {"turn", make("rotation", {{"axis", from("line")}})},
                         {"both", make("add", {{"generators", {from("turn"), from("up")}}})},
                         {"up", make("direction", {{"direction", {0, 0, 1}}})},
                         {"none", make("point_pair", {{"direction", {0, 0, 0}}})}};

}  // namespace

TEST_CASE("A preview has a node for each graph node and a child for each output that can be drawn") {
  Json nodes = ring_graph;
  nodes["size"] = make("number", {{"value", 3}});
  nodes["grid"] = make("grid", {{"count_u", 3}, {"count_v", 4}});
  const Json json = json_of(preview_of(showing(nodes, {"skin", "ring", "size", "grid", "out"})));
  std::vector<std::string> names;
  for (const Json& group : json["nodes"][0]["children"]) {
    const Json& node = json["nodes"][group.get<std::size_t>()];
    names.push_back(node["name"]);
    CHECK(node["extras"]["id"] == names.back());
    CHECK(node["extras"]["type"] == nodes[names.back()]["type"]);
    CHECK(node["extras"].contains("drawable") == (names.back() == "size" || names.back() == "out"));
  }
  CHECK(names == std::vector<std::string>{"grid", "out", "ring", "size", "skin"});
  const auto children = children_of(json);
  REQUIRE(children.size() == 3);
  CHECK(children.at("ring.circle")["extras"] ==
        Json({{"output", "circle"}, {"type", "circle"}, {"count", 1}, {"drawn", 1}}));
  CHECK(children.at("ring.circle")["primitives"][0]["mode"] == 3);
  CHECK(children.at("skin.mesh")["extras"]["type"] == "mesh");
  CHECK(children.at("skin.mesh")["primitives"][0]["mode"] == 4);
  CHECK(children.at("grid.points")["extras"]["drawn"] == 12);
  CHECK(children.at("grid.points")["primitives"][0]["mode"] == 0);
}

TEST_CASE("What is drawn of a wire has the color of its socket, linear as glTF wants it") {
  Json nodes = {{"ring", make("circle", Json::object())},
                {"ball", make("sphere", Json::object())},
                {"spot", make("point", Json::object())},
                {"up", make("vector", {{"z", 1}})},
                {"pair", make("point_pair", {{"position", {0, 0, 0}}, {"direction", {0, 0, 1}}})}};
  const Json json = json_of(preview_of(showing(nodes, {"ring", "ball", "spot", "up", "pair"})));
  const auto children = children_of(json);
  REQUIRE(children.size() == 5);
  for (const auto& [place, child] : children) {
    CAPTURE(place);
    const auto wire = std::ranges::find(wire_types(), child["extras"]["type"].get<std::string>(), &WireInfo::name);
    REQUIRE(wire != wire_types().end());
    const Json& material = json["materials"][child["primitives"][0]["material"].get<std::size_t>()];
    CHECK(material["pbrMetallicRoughness"]["baseColorFactor"] == Json(linear_color(wire->type)));
  }
}

TEST_CASE("Generators are drawn after their kind") {
  std::vector<std::string> all;
  for (const auto& [id, node] : generators.items()) {
    if (node["type"] != "line") all.push_back(id);
  }
  const auto children = children_of(json_of(preview_of(showing(generators, all))));
  const auto kind = [&](const std::string& id) { return children.at(id + ".generator")["extras"]["kind"]; };
  CHECK(kind("null") == "null");
  CHECK(kind("real") == "real");
  CHECK(kind("imaginary") == "imaginary");
  CHECK(kind("flat") == "flat_point");
  CHECK(kind("slide") == "direction");
  CHECK(kind("turn") == "rotation");
  CHECK(kind("both") == "general");
  CHECK(children.size() == 8);
  for (const auto& [name, child] : children) {
    CAPTURE(name);
    CHECK(child["extras"]["type"] == "generator");
    CHECK(child["extras"]["count"] == 1);
    for (const Json& primitive : child["primitives"]) CHECK((primitive["mode"] == 1 || primitive["mode"] == 3));
  }
}

TEST_CASE("A family of several kinds has a child for each of them") {
  const Json nodes = {{"split", make("range", {{"from", -1}, {"to", 1}, {"count", 5}})},
                      {"pairs", make("point_pair", {{"split", from("split")}})}};
  const Json json = json_of(preview_of(showing(nodes, {"pairs"})));
  std::map<std::string, Json> drawn;
  for (const Json& node : json["nodes"]) {
    if (node.contains("mesh")) drawn[node["extras"]["kind"]] = node["extras"];
  }
  REQUIRE(drawn.size() == 3);
  CHECK(drawn["null"]["drawn"] == 1);
  CHECK(drawn["real"]["drawn"] == 2);
  CHECK(drawn["imaginary"]["drawn"] == 2);
  CHECK(drawn["real"]["count"] == 5);
}

TEST_CASE("Single outputs can be asked for, order and repeats do not count") {
  const Json nodes = {{"grid", make("grid")}, {"ring", make("circle")}};
  const std::string whole = preview_of(showing(nodes, {"ring", "grid.points"}));
  CHECK(children_of(json_of(whole)).size() == 2);
  CHECK(preview_of(showing(nodes, {"grid.points", "ring.circle", "ring", "grid.points"})) == whole);
  CHECK(preview_of(showing(nodes, {"grid.u", "ring"})) != whole);
}

TEST_CASE("Points along curves are drawn as lines, also after they were moved, other points as points") {
  const Json nodes = {
      {"ring", make("circle")},
      {"dots", make("sample", {{"shape", from("ring")}, {"count", 32}})},
      {"tau", make("point_pair", {{"position", {3, 0, 0}}})},
      {"k", make("range", {{"from", 0}, {"to", 0.5}, {"count", 3}})},
      {"bent", make("boost", {{"shape", from("dots")}, {"generator", from("tau")}, {"amount", from("k")}})},
      {"dust", make("random", {{"count", 10}})}};
  const auto children = children_of(json_of(preview_of(showing(nodes, {"dots", "bent", "dust.points"}))));
  CHECK(children.at("dots.points")["primitives"][0]["mode"] == 3);
  CHECK(children.at("dots.points")["extras"]["count"] == 1);
  CHECK(children.at("bent.shape")["extras"]["count"] == 3);
  CHECK(children.at("bent.shape")["primitives"].size() == 3);
  CHECK(children.at("dust.points")["primitives"][0]["mode"] == 0);
}

TEST_CASE("Large families are thinned, and what has no end stays within a few sizes of the rest") {
  const Json nodes = {
      {"k", make("range", {{"from", 0}, {"to", 4}, {"count", 5000}})},
      {"ring", make("circle")},
      {"tau", make("point_pair", {{"direction", {1, 0, 0}}})},
      {"bent", make("boost", {{"shape", from("ring")}, {"generator", from("tau")}, {"amount", from("k")}})},
      {"axis", make("line")},
      {"floor", make("osculating_sphere", {{"curvature", 0}})},
      {"dust", make("random", {{"count", 50'000}})}};
  const Json json = json_of(preview_of(showing(nodes, {"bent", "axis", "floor", "dust.points"})));
  const auto children = children_of(json);
  CHECK(children.at("bent.shape")["extras"]["count"] == 5000);
  CHECK(children.at("bent.shape")["extras"]["drawn"] == engine().limits().preview_elements);
  CHECK(children.at("dust.points")["extras"]["drawn"] == engine().limits().preview_points);
  CHECK(children.contains("floor.sphere"));
  CHECK(children.contains("axis.circle"));
  CHECK(extent_of(json) < 60);
}

TEST_CASE("A line crosses everything that is shown with it, wherever it runs") {
  const Json nodes = {{"ring", make("circle", {{"center", {5, 1, 0}}})},
                      {"axis", make("line", {{"point", {4, 0, 2}}, {"direction", {0, 1, 0}}})}};
  const Json json = json_of(preview_of(showing(nodes, {"ring", "axis"})));
  const Json line = children_of(json).at("axis.circle");
  const Json& positions = json["accessors"][line["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  CHECK(positions["min"][1] < -2);
  CHECK(positions["max"][1] > 4);
  CHECK(positions["min"][0] == 4);
  CHECK(positions["max"][2] == 2);
}

TEST_CASE("An evaluation gives the model, the preview, or both, and says so in its report") {
  Asked request = showing(ring_graph, {});
  const Result<Answered> model = answered(engine(), request);
  REQUIRE(model);
  CHECK_FALSE(model->preview);
  CHECK_FALSE(model->report().contains("preview"));
  request.preview = {"ring"};
  const Result<Answered> preview = answered(engine(), request);
  REQUIRE(preview);
  CHECK_FALSE(preview->glb);
  const Json report = preview->report();
  CHECK_FALSE(report.contains("model"));
  CHECK(report["preview"]["nodes"] == Json::array({"ring"}));
  CHECK(report["preview"]["bytes"] == preview->preview->size());
  request.output = "out";
  const Result<Answered> both = answered(engine(), request);
  REQUIRE(both);
  CHECK(*both->glb == *model->glb);
  CHECK(*both->preview == *preview->preview);
  CHECK(both->report()["model"]["bytes"] == model->glb->size());
}

TEST_CASE("The tag of an answer depends on what is drawn, and equal previews are equal bytes") {
  const auto tag = [](const Asked& request) {
    const auto prepared = prepared_for(engine(), request);
    require_none(prepared ? Problems{} : prepared.problems());
    return (*prepared)->model_tag;
  };
  Asked both = showing(ring_graph, {"ring"});
  both.output = "out";
  const std::vector<Asked> requests = {showing(ring_graph, {}), showing(ring_graph, {"ring"}),
                                       showing(ring_graph, {"skin"}), showing(ring_graph, {"ring", "skin"}), both};
  std::set<std::string> tags;
  for (const Asked& request : requests) tags.insert(tag(request));
  CHECK(tags.size() == requests.size());
  CHECK(tag(showing(ring_graph, {"skin", "ring"})) == tag(showing(ring_graph, {"ring", "skin"})));
  const std::unique_ptr<Engine> other_owner = make_engine();
  const Engine& other = *other_owner;
  const Result<Answered> again = answered(other, requests[3]);
  REQUIRE(again);
  CHECK(*again->preview == preview_of(requests[3]));
  CHECK(*again->preview == *answered(other, requests[3])->preview);
}

TEST_CASE("A node with nothing to draw is not evaluated for its preview") {
  const Json nodes = {{"bad", make("expression", {{"formula", "1 / x"}})}, {"ring", make("circle")}};
  const Json json = json_of(preview_of(showing(nodes, {"bad", "ring"})));
  CHECK(json["nodes"][1]["extras"] == Json({{"id", "bad"}, {"type", "expression"}, {"drawable", false}}));
  const Result<Answered> failed = answered(
      engine(), showing({{"ring", make("circle", {{"radius", from("bad")}})}, {"bad", nodes["bad"]}}, {"ring"}));
  REQUIRE_FALSE(failed);
  CHECK(failed.problems().front().node == "bad");
}

TEST_CASE("A preview works without an export node, and broken nodes elsewhere do not matter") {
  Json nodes = {{"ring", make("circle")}, {"bad", make("boost")}, {"worse", make("nothing")}};
  CHECK(children_of(json_of(preview_of(showing(nodes, {"ring"})))).size() == 1);
  CHECK(refused(showing(nodes, {"bad"})).front().code == "required-input-missing");
  CHECK(refused(showing(nodes, {"worse"})).front().code == "unknown-node-type");
}

TEST_CASE("A bypassed node draws what it passes on") {
  Json nodes = {{"ring", make("circle")},
                {"moved", make("translate", {{"shape", from("ring")}, {"vector", {9, 0, 0}}})}};
  nodes["moved"]["bypass"] = true;
  const std::string glb = preview_of(showing(nodes, {"moved"}));
  CHECK(children_of(json_of(glb)).at("moved.shape")["extras"]["type"] == "circle");
  CHECK(extent_of(json_of(glb)) < 1.01);
}

TEST_CASE("Places that are not there are problems that point to their entry") {
  const auto wrong = [](const std::string& entry) {
    const Problems problems = refused(showing(ring_graph, {"ring", entry}));
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].pointer == "/preview/1");
    return problems[0].code;
  };
  CHECK(wrong("rin") == "unknown-node");
  CHECK(wrong("") == "unknown-node");
  CHECK(wrong("ring.disk") == "unknown-port");
  CHECK(wrong("ring.") == "unknown-port");
  CHECK(wrong(std::string(100'000, 'x')) == "unknown-node");
  CHECK(refused(showing(ring_graph, {"a", "b"})).size() == 2);
}

TEST_CASE("Hostile previews meet named limits") {
  const Limits& limits = engine().limits();
  const Problems many = refused(showing(ring_graph, std::vector<std::string>(10'000, "ring")));
  CHECK(many.front().code == "limit-exceeded");
  CHECK(many.front().pointer == "/preview");
  // As many as are accepted of the largest families, and meshes that are too large only together.
  Json nodes = {{"k", make("range", {{"count", 200'000}})}, {"ring", make("circle", {{"radius", from("k")}})}};
  std::vector<std::string> all;
  for (std::size_t i = 0; i + 1 < limits.previews; ++i) {
    const std::string id = "t" + std::to_string(i);
    nodes[id] = make("translate", {{"shape", from("ring")}, {"vector", {0, 0, i}}});
    all.push_back(id);
  }
  CHECK(preview_of(showing(nodes, {all.begin(), all.begin() + 4})).size() < (std::size_t{4} << 20));
  Json balls = Json::object();
  std::vector<std::string> names;
  for (int i = 0; i < 6; ++i) {
    names.push_back("ball" + std::to_string(i));
    balls[names.back()] = make("sphere_mesh", {{"segments", 1000}, {"rings", 1000}});
  }
  const Problems large = refused(showing(balls, names));
  CHECK(large.front().code == "limit-exceeded");
  CHECK(large.front().pointer == "/preview");
}
