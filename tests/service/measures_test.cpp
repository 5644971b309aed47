// Measures: values of chosen outputs in the report of an evaluation.

#include <catch2/catch.hpp>

#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json measured_nodes = {{"radii", make("range", {{"from", 1}, {"to", 3}, {"count", 3}})},
                             {"ring", make("circle", {{"radius", 2}})},
                             {"ball", make("sphere_mesh", {{"radius", 1}})},
                             {"size", make("measure", {{"model", from("ball")}})},
                             {"held", make("check", {{"value", 1}, {"minimum", 0}})},
                             {"out", make("export", {{"model", from("ball")}})}};

Json measured(const Asked& asked) {
  const Result<Answered> answer = answered(engine(), asked);
  require_none(answer ? Problems{} : answer.problems());
  return answer->report()["measures"];
}

std::string refusal(const Asked& asked) {
  const auto prepared = prepared_for(engine(), asked);
  REQUIRE_FALSE(prepared);
  const Problem& problem = prepared.problems().front();
  return problem.code + " " + problem.pointer.value_or("");
}

}  // namespace

TEST_CASE("A measure is the value that inspect shows, bare where there are no axes") {
  const Json graph = document(measured_nodes);
  const Json told = measured({.graph = graph, .measures = {"radii", "ring", "size.volume", "radii"}});
  CHECK(told["radii"] == inspected(engine(), graph, "radii"));
  CHECK(told["ring"] == inspected(engine(), graph, "ring").front());
  CHECK(told["size.volume"] == inspected(engine(), graph, "size.volume").front());
  CHECK(told.size() == 3);
  CHECK_FALSE(answered(engine(), {.graph = graph})->report().contains("measures"));
}

TEST_CASE("Without an output only measures and checks are made") {
  const auto answer =
      answered(engine(), {.graph = document(measured_nodes), .measures = {"size.volume"}, .without_output = true});
  REQUIRE(answer);
  CHECK(answer->glb == nullptr);
  const Json report = answer->report();
  CHECK_FALSE(report.contains("model"));
  CHECK(report["checks"].size() == 1);
  CHECK(report["nodes"]["out"]["cached"] == false);
}

TEST_CASE("The measure of a bypassed node is what stands there, and has its own content") {
  Json changed = measured_nodes;
  changed["moved"] = make("translate", {{"shape", from("ring")}, {"vector", {0, 0, 1}}});
  changed["moved"]["bypass"] = true;
  changed["other"] = changed["moved"];
  changed["other"]["inputs"]["shape"] = from("radii_ring");
  changed["radii_ring"] = make("circle", {{"radius", 5}});
  const Json graph = document(changed);
  CHECK(measured({.graph = graph, .measures = {"moved"}})["moved"]["radius"] == 2);
  CHECK(measured({.graph = graph, .measures = {"other"}})["other"]["radius"] == 5);
  const auto content = [&](const std::string& place) {
    return (*prepared_for(engine(), {.graph = graph, .measures = {place}, .without_output = true}))->content;
  };
  CHECK(content("moved") != content("other"));
}

TEST_CASE("A measure that is not there, or too large, is refused with its place") {
  const Json graph = document(measured_nodes);
  CHECK(refusal({.graph = graph, .measures = {"ring", "rin"}}) == "unknown-node /measures/1");
  CHECK(refusal({.graph = graph, .measures = {"size.volum"}}) == "unknown-port /measures/0");
  Json large = measured_nodes;
  large["radii"]["inputs"]["count"] = 10'001;
  CHECK(refusal({.graph = document(large), .measures = {"radii"}}) == "limit-exceeded /measures");
  CHECK(refusal({.graph = graph, .measures = std::vector<std::string>(257, "ring")}) == "limit-exceeded /measures");
}
