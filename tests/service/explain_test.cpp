// Explanations: what an evaluation would do, told before it does it, and held against what it then does.

#include <catch2/catch.hpp>
#include <set>

#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A ball that is moved by one parameter and colored by none, beside a node that nothing asks for.
Json moved_ball() {
  Json graph = document(
      {{"ball", make("sphere_mesh", {{"segments", 32}, {"rings", 16}})},
       {"pair", make("point_pair", {{"position", {2, 0, 0}}})},
       {"moved",
        make("boost", {{"shape", from("ball")}, {"generator", from("pair")}, {"amount", {{"parameter", "amount"}}}})},
       {"size", make("measure", {{"model", from("moved")}})},
       {"lonely", make("circle", {{"radius", 2}})},
       {"out", make("export", {{"model", from("moved")}})}});
  graph["parameters"] = {{"amount", {{"type", "number"}, {"default", 0.1}, {"min", 0}, {"max", 1}}}};
  return graph;
}

Json explained(const Engine& engine, const Asked& asked) {
  const auto prepared = prepared_for(engine, asked);
  require_none(prepared ? Problems{} : prepared.problems());
  return engine.explain(**prepared);
}

Json evaluated(const Engine& engine, const Asked& asked) {
  const auto answer = answered(engine, asked);
  require_none(answer ? Problems{} : answer.problems());
  return answer->report();
}

/// The nodes that an explanation says will run.
std::set<std::string> running(const Json& explanation) {
  std::set<std::string> ids;
  for (const auto& [id, node] : explanation["nodes"].items()) {
    if (node["state"] == "runs") ids.insert(id);
  }
  return ids;
}

/// Those that did, of all that were needed.
std::set<std::string> ran(const Json& report, const Json& explanation) {
  std::set<std::string> ids;
  for (const auto& [id, node] : report["nodes"].items()) {
    if (node["cached"] == false && explanation["nodes"][id]["state"] != "skipped") ids.insert(id);
  }
  return ids;
}

Json because(const Json& explanation, const std::string& node) { return explanation["nodes"][node]["why"]; }

Json parameter(const std::string& name) { return {{"because", "parameter"}, {"name", name}}; }
Json upstream(const std::string& name) { return {{"because", "upstream"}, {"name", name}}; }
const Json is_new = {{"because", "new"}};
const Json evicted = {{"because", "evicted"}};

/// No mesh of a graph has more vertices than is said before.
void check_vertices(const Json& graph) {
  const auto engine = example_engine();
  const Json explanation = explained(*engine, {.graph = graph});
  for (const auto& [id, node] : explanation["nodes"].items()) {
    for (const auto& [output, shape] : node["outputs"].items()) {
      if (shape["type"] != "mesh") continue;
      CAPTURE(id, output);
      const Json value = inspected(*engine, graph, id + "." + output);
      std::size_t vertices = 0;
      for (const Json& mesh : value) vertices += mesh["vertices"].get<std::size_t>();
      CHECK(vertices <= shape["most_vertices"].get<std::size_t>());
      CHECK(shape["vertices"] <= shape["most_vertices"]);
    }
  }
}

}  // namespace

TEST_CASE("An explanation names what runs and why: new, a parameter, upstream, evicted") {
  const auto engine = make_engine();
  const Json graph = moved_ball();
  const Json first = explained(*engine, {.graph = graph});
  CHECK(running(first) == std::set<std::string>{"ball", "pair", "moved", "out"});
  CHECK(because(first, "ball") == Json::array({is_new}));
  CHECK(because(first, "moved") == Json::array({upstream("ball"), upstream("pair")}));
  CHECK(first["runs"] == 4);
  CHECK(first["known"] == 0);
  CHECK(first["milliseconds"] > 0);

  evaluated(*engine, {.graph = graph});
  const Json again = explained(*engine, {.graph = graph});
  CHECK(running(again).empty());
  CHECK(again["known"] == 1);
  CHECK(again["work"] == 0);
  CHECK(again["bytes"] == 0);
  CHECK(again["nodes"]["out"]["state"] == "known");
  CHECK(again["nodes"]["ball"]["state"] == "skipped");

  const Asked other = {.graph = graph, .parameters = {{"amount", 0.2}}};
  const Json changed = explained(*engine, other);
  CHECK(running(changed) == std::set<std::string>{"moved", "out"});
  CHECK(changed["nodes"]["ball"]["state"] == "known");
  CHECK(because(changed, "moved") == Json::array({parameter("amount")}));
  CHECK(because(changed, "out") == Json::array({upstream("moved")}));
  CHECK(ran(evaluated(*engine, other), changed) == running(changed));

  engine->forget();
  CHECK(because(explained(*engine, other), "ball") == Json::array({is_new}));
}

TEST_CASE("What had to make room runs because it was evicted") {
  Limits limits;
  limits.cache_bytes = 1;
  const auto engine = make_engine(limits);
  evaluated(*engine, {.graph = moved_ball()});
  const Json gone = explained(*engine, {.graph = moved_ball()});
  for (const char* const node : {"ball", "pair", "moved", "out"}) CHECK(because(gone, node) == Json::array({evicted}));
}

TEST_CASE("What an explanation predicts is what runs, in every example") {
  for (const auto& [example, graph] : examples()) {
    CAPTURE(example);
    const auto engine = example_engine();
    const Asked asked = {.graph = graph, .quality = Quality::draft};
    const Json explanation = explained(*engine, asked);
    const Json report = evaluated(*engine, asked);
    CHECK(running(explanation) == ran(report, explanation));
    CHECK(explanation["runs"] <= running(explanation).size());
  }
}

TEST_CASE("No mesh has more vertices than an explanation says, in every example and where surfaces and tubes are cut") {
  for (const auto& [example, graph] : examples()) {
    CAPTURE(example);
    check_vertices(graph);
  }
  // Every other point is beyond the clip radius.
  const auto zigzag = [](int count, const char* formula, const std::string& shape) {
    const auto range = [&](const char* axis) {
      return make("range", {{"from", 0}, {"to", count - 1}, {"count", count}, {"axis", axis}});
    };
    const auto expression = [&](const char* text) {
      return make("expression",
                  {{"formula", text}, {"x", from("i.values")}, {"y", shape == "tube" ? Json(0) : from("j.values")}});
    };
    return document({{"i", range("i")},
                     {"j", range("j")},
                     {"height", expression(formula)},
                     {"x", expression("x / 100")},
                     {"y", expression("y / 100")},
                     {"way", make("vector", {{"x", from("x")}, {"y", from("y")}, {"z", from("height")}})},
                     {"points", make("translate", {{"shape", {0, 0, 0}}, {"vector", from("way")}})},
                     {"cut", make(shape, {{"shape", from("points")}, {"clip_radius", 1.5}})},
                     {"out", make("export", {{"model", from("cut")}})}});
  };
  for (int count = 3; count < 12; ++count) {
    CAPTURE(count);
    check_vertices(zigzag(count, "1 + x - 2 * floor(x / 2)", "tube"));
    check_vertices(zigzag(count, "1 + x - 2 * floor(x / 2)", "surface"));
    check_vertices(zigzag(count, "1 + x + y - 2 * floor((x + y) / 2)", "surface"));
  }
}

TEST_CASE("Walls and caps of meshes that are nearly all border have no more vertices than an explanation says") {
  for (const int count : {2, 3, 40, 9000}) {
    std::vector<Json> closed = {make("thicken", {{"shape", from("strip")}, {"thickness", 0.001}}),
                                make("cap", {{"shape", from("strip")}})};
    // A dome of as many rings on a long border would be refused.
    if (count < 100) closed.push_back(make("cap", {{"shape", from("strip")}, {"kind", "dome"}, {"rings", 200}}));
    for (const Json& node : closed) {
      CAPTURE(count, node.dump());
      check_vertices(document({{"grid", make("grid", {{"count_u", count}, {"count_v", 2}})},
                               {"places", make("range", {{"count", count < 100 ? 5 : 1}, {"axis", "place"}})},
                               {"way", make("vector", {{"x", from("places.values")}})},
                               {"moved", make("translate", {{"shape", from("grid.points")}, {"vector", from("way")}})},
                               {"strip", make("surface", {{"shape", from("moved")}, {"over", "u"}, {"along", "v"}})},
                               {"closed", node},
                               {"out", make("export", {{"model", from("closed")}})}}));
    }
  }
}

TEST_CASE("Times are predicted from what nodes have taken") {
  const auto engine = make_engine();
  const auto ball = [](int rings) {
    return Asked{.graph = document({{"ball", make("sphere_mesh", {{"segments", 400}, {"rings", rings}})},
                                    {"size", make("measure", {{"model", from("ball")}})},
                                    {"out", make("export", {{"model", from("ball")}})}}),
                 .measures = {"size.volume"}};
  };
  const double before = explained(*engine, ball(200))["nodes"]["ball"]["milliseconds"];
  const Json report = evaluated(*engine, ball(100));
  const Json after = explained(*engine, ball(200))["nodes"]["ball"];
  CHECK(after["milliseconds"] != before);
  const double taken = report["nodes"]["ball"]["milliseconds"];
  const double work = explained(*make_engine(), ball(100))["nodes"]["ball"]["work"];
  CHECK(after["milliseconds"].get<double>() == Approx(taken / work * after["work"].get<double>()).epsilon(1e-3));
}
