// What the engine says about requests that are wrong, and where.

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A graph without faults, to put one in.
Json sound() {
  Json graph = document({{"ring", make("circle", {{"radius", {{"parameter", "size"}}}})},
                         {"skin", make("tube", {{"shape", from("ring")}, {"radius", 0.1}})},
                         {"out", make("export", {{"model", from("skin")}})}});
  graph["parameters"] = {{"size", {{"type", "number"}, {"default", 1}, {"min", 0.5}, {"max", 2}}}};
  return graph;
}

Asked request_for(Json graph, Json parameters = Json::object()) {
  return {.graph = std::move(graph), .parameters = std::move(parameters), .output = "", .quality = Quality::final};
}

/// The sound graph with a value put at a pointer.
Json with(const std::string& pointer, Json value) {
  Json graph = sound();
  graph[Json::json_pointer(pointer)] = std::move(value);
  return graph;
}

struct Fault {
  std::string code, pointer;
  Json graph;
  Json parameters = Json::object();
};

std::vector<Fault> faults() {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  Json cycle = with("/nodes/ring/inputs/center", from("loop"));
  cycle["nodes"]["loop"] = make("translate", {{"shape", from("loop")}});
  return {
      {"unknown-parameter", "/parameters/sise", sound(), {{"sise", 1}}},
      {"out-of-range", "/parameters/size", sound(), {{"size", 3}}},
      {"type-mismatch", "/parameters/size", sound(), {{"size", "wide"}}},
      {"non-finite", "/parameters/size", sound(), {{"size", nan}}},
      {"type-mismatch", "/parameters", sound(), Json::array()},
      {"non-finite", "/graph/nodes/skin/inputs/radius", with("/nodes/skin/inputs/radius", infinity)},
      {"type-mismatch", "/graph/nodes/ring/inputs/center", with("/nodes/ring/inputs/center", {0, nan, 0})},
      {"out-of-range", "/graph/nodes/skin/inputs/radius", with("/nodes/skin/inputs/radius", -1)},
      {"type-mismatch", "/graph/nodes/skin/inputs/sides", with("/nodes/skin/inputs/sides", 3.5)},
      {"type-mismatch", "/graph/nodes/skin/inputs/shape",
       with("/nodes/skin/inputs/shape", from("skin2"))
           .patch(Json::parse(R"([{"op": "add", "path": "/nodes/skin2", "value": {"type": "number"}}])"))},
      {"unknown-port", "/graph/nodes/skin/inputs/radios", with("/nodes/skin/inputs/radios", 1)},
      {"unknown-node-type", "/graph/nodes/skin/type", with("/nodes/skin/type", "tub")},
      {"dangling-link", "/graph/nodes/skin/inputs/shape", with("/nodes/skin/inputs/shape", from("rings"))},
      {"dangling-link", "/graph/nodes/skin/inputs/shape", with("/nodes/skin/inputs/shape", from("ring.disk"))},
      {"unknown-parameter", "/graph/nodes/skin/inputs/radius",
       with("/nodes/skin/inputs/radius", {{"parameter", "sise"}})},
      {"required-input-missing", "/graph/nodes/out/inputs/model", with("/nodes/out/inputs", Json::object())},
      {"graph-has-cycle", "/graph/nodes/loop", cycle},
      {"unknown-member", "/graph/nodez", with("/nodez", Json::object())},
      {"unknown-member", "/graph/nodes/skin/imputs", with("/nodes/skin/imputs", Json::object())},
      {"axis-mismatch", "/graph/nodes/skin/inputs/shape", with("/nodes/skin/inputs/shape", {0, 0, 0})},
      {"limit-exceeded", "/graph/nodes/skin",
       with("/nodes/skin", make("sphere_mesh", {{"segments", 8192}, {"rings", 8192}}))},
  };
}

/// The same of nodes that the output does not depend on: an evaluation does not mind them.
std::vector<Fault> faults_elsewhere() {
  return {
      {"out-of-range", "/graph/nodes/k/inputs/count", with("/nodes/k", make("range", {{"count", 1'000'000'000}}))},
      {"limit-exceeded", "/graph/nodes/sheet",
       with("/nodes/sheet", make("grid", {{"count_u", 65536}, {"count_v", 65536}}))},
      {"unknown-node-type", "/graph/nodes/b/type", with("/nodes/b", make("bost", {{"shape", from("skin")}}))},
      {"required-input-missing", "/graph/nodes/b/inputs/generator",
       with("/nodes/b", make("boost", {{"shape", from("skin")}}))},
      {"graph-has-cycle", "/graph/nodes/loop", with("/nodes/loop", make("translate", {{"shape", from("loop")}}))},
  };
}

}  // namespace

TEST_CASE("Every fault has its stable code and the pointer to its place") {
  for (const Fault& fault : faults()) {
    CAPTURE(fault.code, fault.pointer);
    const auto prepared = prepared_for(engine(), request_for(fault.graph, fault.parameters));
    REQUIRE_FALSE(prepared);
    CAPTURE(to_json(prepared.problems()).dump());
    REQUIRE(prepared.problems().size() == 1);
    const Problem& problem = prepared.problems().front();
    CHECK(problem.code == fault.code);
    CHECK(to_json(prepared.problems())[0]["pointer"] == fault.pointer);
    CHECK_FALSE(problem.detail.empty());
    CHECK(to_json(prepared.problems())[0]["detail"] == problem.detail);
  }
}

TEST_CASE("Validation and evaluation find the same problems") {
  for (const Fault& fault : faults()) {
    CAPTURE(fault.code, fault.pointer);
    const Json verdict = *engine().validate(*engine().read(fault.graph), fault.parameters, Cancel());
    CHECK(verdict["valid"] == false);
    CHECK(verdict["errors"] == to_json(prepared_for(engine(), request_for(fault.graph, fault.parameters)).problems()));
  }
  CHECK((*engine().validate(*engine().read(sound()), Json::object(), Cancel()))["valid"] == true);
}

TEST_CASE("A fault elsewhere is a warning of the evaluation and a problem of the validation") {
  const Result<Answered> usual = answered(engine(), request_for(sound()));
  REQUIRE(usual);
  for (const Fault& fault : faults_elsewhere()) {
    CAPTURE(fault.code, fault.pointer);
    const Result<Answered> answer = answered(engine(), request_for(fault.graph));
    require_none(answer ? Problems{} : answer.problems());
    CHECK(*answer->glb == *usual->glb);
    const Json warnings = answer->report()["warnings"];
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0]["code"] == fault.code);
    CHECK(warnings[0]["pointer"] == fault.pointer);
    const Json verdict = *engine().validate(*engine().read(fault.graph), Json::object(), Cancel());
    CHECK(verdict["errors"] == warnings);
    const auto seen = engine().inspect({.graph = engine().read(fault.graph),
                                        .parameters = Json::object(),
                                        .node = "ring",
                                        .output = "",
                                        .full = false},
                                       Job());
    CHECK(seen);
  }
}

TEST_CASE("A check that cannot run fails the answer, and says why") {
  Json graph = with("/nodes/limit", make("check", {{"value", from("size")}, {"maximum", 5}}));
  graph["nodes"]["size"] = make("expression", {{"formula", "x"}, {"y", from("nowhere")}});
  graph["nodes"]["loose"] = make("check");
  const auto refused = prepared_for(engine(), request_for(graph));
  REQUIRE_FALSE(refused);
  REQUIRE(refused.problems().size() == 2);
  CHECK(refused.problems()[0].code == "check-failed");
  CHECK(refused.problems()[0].node == "limit");
  CHECK(refused.problems()[0].detail == "the check cannot run: it stands behind a node that has a problem");
  CHECK(refused.problems()[0].pointer == "/nodes/limit");
  CHECK(refused.problems()[1].node == "loose");
  CHECK(refused.problems()[1].detail.starts_with("the check cannot run: value is missing"));
  graph["nodes"]["loose"]["bypass"] = true;
  graph["nodes"]["limit"]["bypass"] = true;
  CHECK(prepared_for(engine(), request_for(graph)));
}

TEST_CASE("Outputs and nodes that are not there are named with what is") {
  Asked request = request_for(sound());
  request.output = "skin";
  const auto wrong_output = prepared_for(engine(), request);
  REQUIRE_FALSE(wrong_output);
  CHECK(wrong_output.problems().front().code == "unknown-output");
  CHECK(wrong_output.problems().front().detail.find("out") != std::string::npos);
  const auto no_node = engine().inspect(
      {.graph = engine().read(sound()), .parameters = Json::object(), .node = "rin", .output = "", .full = false},
      Job());
  REQUIRE_FALSE(no_node);
  CHECK(no_node.problems().front().code == "unknown-node");
  CHECK(no_node.problems().front().detail.find("ring") != std::string::npos);
  const auto no_port = engine().inspect(
      {.graph = engine().read(sound()), .parameters = Json::object(), .node = "ring", .output = "disk", .full = false},
      Job());
  REQUIRE_FALSE(no_port);
  CHECK(no_port.problems().front().code == "unknown-port");
}

TEST_CASE("Problems found while evaluating name node and place too") {
  Json graph = with("/nodes/ring/inputs/radius", from("bad"));
  graph["nodes"]["bad"] = make("expression", {{"formula", "1 / x"}});
  const Result<Answered> answer = answered(engine(), request_for(graph));
  REQUIRE_FALSE(answer);
  CHECK(answer.problems().front().code == "non-finite");
  CHECK(answer.problems().front().node == "bad");
  CHECK(answer.problems().front().pointer == "/nodes/bad");
}

TEST_CASE("A check fails the answer although the output does not need it") {
  Json graph = sound();
  graph["nodes"]["size"] = make("measure", {{"model", from("skin")}});
  graph["nodes"]["limit"] = make("check", {{"value", from("size.area")}, {"maximum", 1}, {"message", "too large"}});
  const Result<Answered> answer = answered(engine(), request_for(graph));
  REQUIRE_FALSE(answer);
  CHECK(answer.problems().front().code == "check-failed");
  CHECK(answer.problems().front().pointer == "/nodes/limit/inputs/value");
  graph["nodes"]["limit"]["inputs"]["maximum"] = 100;
  const Result<Answered> passed = answered(engine(), request_for(graph));
  require_none(passed ? Problems{} : passed.problems());
  CHECK(passed->report()["checks"][0]["node"] == "limit");
  CHECK(passed->report()["checks"][0]["passed"] == true);
}

TEST_CASE("Graphs as large as the limit are answered, larger ones are refused") {
  Json graph = sound();
  for (std::size_t i = graph["nodes"].size(); i < engine().limits().nodes; ++i) {
    const std::string previous = "n" + std::to_string(i - 1);
    Json inputs = graph["nodes"].contains(previous) ? Json{{"value", from(previous)}} : Json{{"value", 1}};
    graph["nodes"]["n" + std::to_string(i)] = make("number", std::move(inputs));
  }
  REQUIRE(graph["nodes"].size() == engine().limits().nodes);
  const Result<Answered> answer = answered(engine(), request_for(graph));
  require_none(answer ? Problems{} : answer.problems());
  const std::string last = "n" + std::to_string(engine().limits().nodes - 1);
  CHECK(inspected(engine(), graph, last) == Json{1.0});
  graph["nodes"]["one_more"] = make("number");
  const auto refused = prepared_for(engine(), request_for(graph));
  REQUIRE_FALSE(refused);
  CHECK(refused.problems().front().code == "limit-exceeded");
  CHECK(refused.problems().front().pointer == "/nodes");
}

TEST_CASE("A deadline and a stop end a large evaluation inside its kernels") {
  Json generators = Json::array();
  Json nodes = {{"sheet", make("grid", {{"count_u", 2000}, {"count_v", 2000}})}};
  for (int i = 0; i < 64; ++i) {
    const std::string id = "g" + std::to_string(i);
    nodes[id] = make("point_pair", {{"position", {0.1 * i, 0, 1}}});
    generators.push_back(from(id));
  }
  nodes["bent"] =
      make("warp", {{"shape", from("sheet")}, {"generators", generators}, {"power", 1.5}, {"softening", 1}});
  nodes["skin"] = make("surface", {{"shape", from("bent")}});
  nodes["out"] = make("export", {{"model", from("skin")}});
  const Json graph = document(nodes);
  const auto problem_with = [&](const Job& job) {
    const Result<Answered> answer = answered(engine(), request_for(graph), job);
    REQUIRE_FALSE(answer);
    REQUIRE(answer.problems().size() == 1);
    return answer.problems().front().code;
  };
  CHECK(problem_with(Job{Cancel(Cancel::Clock::now() + std::chrono::milliseconds(30))}) == "deadline");
  const Job gone;
  gone.cancel.stop(StopReason::client_gone);
  CHECK(problem_with(gone) == "client-gone");
  const Job superseded;
  superseded.cancel.stop(StopReason::superseded);
  CHECK(problem_with(superseded) == "superseded");
  // What was stopped leaves nothing half done behind.
  const Json small = with("/nodes/ring/inputs/center", {1, 2, 3});
  CHECK(file_of(engine(), request_for(small)) == file_of(*make_engine(), request_for(small)));
}
