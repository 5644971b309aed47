// What graphs look like from outside, and what differs between two of them.

#include "service/interface.h"

#include <catch2/catch.hpp>

#include "service/engine.h"
#include "service/graph_difference.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

Json parameters() {
  return {{"reach", {{"type", "number"}, {"default", 0.5}, {"min", 0}, {"max", 2}, {"step", 0.1}, {"unit", "m"}}},
          {"count", {{"type", "integer"}, {"default", 3}, {"label", "Count"}}},
          {"closed", {{"type", "boolean"}, {"default", true}, {"description", "Whether."}}},
          {"rule", {{"type", "choice"}, {"default", "1"}, {"choices", {"1", "true"}}}},
          {"axis", {{"type", "vector"}, {"default", {0, 0, 1}}}},
          {"paint", {{"type", "color"}, {"default", {1, 0, 0}}}}};
}

Json interface() {
  Json graph = document({{"out", make("export")}, {"ball", make("sphere_mesh")}, {"off", make("export")}});
  graph["nodes"]["off"]["bypass"] = true;
  graph["parameters"] = parameters();
  const auto engine = make_engine();
  const Result<Json> interface = engine->interface(*engine->read(graph));
  REQUIRE(interface);
  return *interface;
}

}  // namespace

TEST_CASE("An interface tells types, bounds, defaults and words of parameters, and the outputs") {
  const Json found = interface();
  CHECK(found["outputs"] == Json{"out"});
  const Json& properties = found["parameters"]["properties"];
  CHECK(properties.size() == 6);
  CHECK(properties["reach"] ==
        Json{{"type", "number"}, {"default", 0.5}, {"minimum", 0}, {"maximum", 2}, {"step", 0.1}, {"unit", "m"}});
  CHECK(properties["count"] == Json{{"type", "integer"}, {"default", 3}, {"title", "Count"}});
  CHECK(properties["closed"] == Json{{"type", "boolean"}, {"default", true}, {"description", "Whether."}});
  CHECK(properties["rule"]["enum"] == Json{"1", "true"});
  CHECK(properties["axis"]["minItems"] == 3);
  CHECK(properties["paint"]["maxItems"] == 4);
}

TEST_CASE("What is no document has no interface but a problem") {
  const auto engine = make_engine();
  CHECK_FALSE(engine->interface(*engine->read({{"nodes", 1}})));
}

TEST_CASE("Texts become what their parameters want, and stay texts where they cannot") {
  const Limits limits;
  const auto value = [&, found = interface()](const char* name, const char* text) {
    return parameters_from_text(found, {{name, text}}, limits)[name];
  };
  CHECK(value("reach", "1.5") == 1.5);
  CHECK(value("reach", "1e-3") == 0.001);
  CHECK(value("reach", "far") == "far");
  CHECK(value("reach", "") == "");
  CHECK(value("reach", "NaN") == "NaN");
  CHECK(value("count", "4") == 4);
  CHECK(value("closed", "false") == false);
  CHECK(value("rule", "1") == "1");
  CHECK(value("rule", "true") == "true");
  CHECK(value("axis", "1,0,0") == Json{1, 0, 0});
  CHECK(value("axis", "[1,0,0]") == Json{1, 0, 0});
  CHECK(value("paint", "0.5, 0.5, 1") == Json{0.5, 0.5, 1});
  CHECK(value("unknown", "1") == "1");
}

TEST_CASE("A document differs from itself in nothing, and written otherwise neither") {
  const Json graph = document({{"ball", make("sphere_mesh", {{"radius", 1}})}});
  Json written = graph;
  written["nodes"]["ball"]["inputs"]["radius"] = 1.0;
  written["nodes"]["ball"]["bypass"] = false;
  for (const Json& difference : {graph_difference(graph, graph), graph_difference(graph, written)}) {
    for (const char* part : {"nodes", "parameters"}) {
      for (const char* kind : {"added", "removed", "changed"}) CHECK(difference[part][kind].empty());
    }
  }
}

TEST_CASE("A change of type, bypass, inputs or members is told with what was and is") {
  Json before = document({{"a", make("sphere_mesh", {{"radius", 1}, {"rings", 4}})}});
  before["parameters"] = parameters();
  Json after = before;
  after["nodes"]["a"] = make("box_mesh", {{"radius", 1}, {"size", 2}});
  after["nodes"]["a"]["bypass"] = true;
  after["parameters"]["reach"].erase("unit");
  const Json difference = graph_difference(before, after);
  CHECK(difference["nodes"]["changed"]["a"] == Json{{"type", {{"from", "sphere_mesh"}, {"to", "box_mesh"}}},
                                                    {"bypass", {{"from", false}, {"to", true}}},
                                                    {"inputs", {{"rings", {{"from", 4}}}, {"size", {{"to", 2}}}}}});
  CHECK(difference["parameters"]["changed"] == Json{{"reach", {{"unit", {{"from", "m"}}}}}});
}

TEST_CASE("Anything can be compared, whatever it is") {
  for (const Json& odd : {Json(nullptr), Json(1), Json::array(), Json{{"nodes", 1}}, Json{{"nodes", {{"a", 1}}}},
                          Json{{"nodes", {{"a", {{"bypass", 3}, {"inputs", nullptr}}}}}}}) {
    CHECK_NOTHROW(graph_difference(odd, document({{"a", make("circle")}})));
    CHECK_NOTHROW(graph_difference(document({{"a", make("circle")}}), odd));
  }
}
