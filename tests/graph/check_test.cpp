#include <catch2/catch.hpp>

#include "tests/graph/toy_registry.h"
#include "tests/support/graphs.h"

using namespace dini;
using support::checked;
using support::codes;
using support::document;
using support::from;
using support::toy_registry;

namespace {

Json toy_node(const char* type, Json inputs) { return {{"type", type}, {"inputs", std::move(inputs)}}; }

}  // namespace

TEST_CASE("A check reports every root problem at once and blocks what stands behind") {
  const Json graph = document({{"a", toy_node("constan", {{"value", 1}})},
                               {"b", toy_node("constant", {{"valeu", 1}})},
                               {"c", toy_node("constant", {{"value", "one"}})},
                               {"d", toy_node("constant", {{"value", 101e6}})},
                               {"e", toy_node("sum", {{"b", 1}})},
                               {"f", toy_node("sum", {{"a", from("nowhere")}})},
                               {"g", toy_node("sum", {{"a", from("c.result")}})},
                               {"h", toy_node("sum", {{"a", from("a")}, {"b", from("d")}})},
                               {"i", toy_node("ramp", {{"count", 3.5}})},
                               {"j", toy_node("shifted", {{"point", from("k")}})},
                               {"k", toy_node("constant", Json::object())},
                               {"l", toy_node("sum", {{"a", {{"parameter", "p"}}}})}});
  const CheckReport report = checked(toy_registry, graph);
  CHECK(codes(report.problems) == std::multiset<std::string>{"unknown-node-type a", "unknown-port b.valeu",
                                                             "type-mismatch c.value", "out-of-range d.value",
                                                             "required-input-missing e.a", "dangling-link f.a",
                                                             "dangling-link g.a", "type-mismatch i.count",
                                                             "type-mismatch j.point", "unknown-parameter l.a"});
  CHECK(report.blocked == std::vector<std::string>{"h"});
}

TEST_CASE("Problems say what would be accepted and carry a fix where one is known") {
  const auto only = [&](const Json& node) {
    const CheckReport report = checked(toy_registry, document({{"n", node}}));
    REQUIRE(report.problems.size() == 1);
    return report.problems[0];
  };
  const Problem type = only(toy_node("rampp", Json::object()));
  CHECK(type.detail == R"(there is no node type "rampp"; did you mean "ramp"?)");
  CHECK(type.fix == Json::parse(R"([{"op": "replace", "path": "/nodes/n/type", "value": "ramp"}])"));
  const Problem port = only(toy_node("ramp", {{"cuont", 4}}));
  CHECK(port.fix ==
        Json::parse(R"([{"op": "move", "from": "/nodes/n/inputs/cuont", "path": "/nodes/n/inputs/count"}])"));
  const Problem range = only(toy_node("constant", {{"value", -200}}));
  CHECK(range.detail == "value: got -200, accepted is -100 to 1000000");
  CHECK(range.fix == Json::parse(R"([{"op": "replace", "path": "/nodes/n/inputs/value", "value": -100}])"));
  const Problem link = only(toy_node("ramp", {{"count", from("n")}}));
  CHECK(link.code == "graph-has-cycle");
}

TEST_CASE("A cycle is named in order and everything behind it is blocked") {
  const CheckReport report = checked(toy_registry, document({{"a", toy_node("sum", {{"a", from("c")}})},
                                                             {"b", toy_node("sum", {{"a", from("a")}})},
                                                             {"c", toy_node("sum", {{"a", from("b")}})},
                                                             {"d", toy_node("sum", {{"a", from("c")}})}}));
  REQUIRE(report.problems.size() == 1);
  CHECK(report.problems[0].code == "graph-has-cycle");
  CHECK(report.problems[0].detail.find("b -> c -> a -> b") != std::string::npos);
  CHECK(report.blocked == std::vector<std::string>{"a", "c", "d"});
}

TEST_CASE("A wire cannot carry a literal-only value") {
  const CheckReport report =
      checked(toy_registry,
              document({{"n", toy_node("constant", {{"value", 3}})}, {"r", toy_node("ramp", {{"count", from("n")}})}}));
  CHECK(codes(report.problems) == std::multiset<std::string>{"type-mismatch r.count"});
}

TEST_CASE("Too many samples are refused before anything is computed, at the node to blame") {
  const Json graph = document({{"a", toy_node("ramp", {{"count", 100000}})},
                               {"b", toy_node("ramp", {{"count", 100000}})},
                               {"s", toy_node("sum", {{"a", from("a")}, {"b", from("b")}})}});
  const CheckReport report = checked(toy_registry, graph);
  REQUIRE(codes(report.problems) == std::multiset<std::string>{"limit-exceeded s"});
  CHECK(report.problems[0].detail.find("10000000000") != std::string::npos);
  CHECK(codes(checked(toy_registry, document({{"a", toy_node("ramp", {{"count", 1000000000}})}})).problems) ==
        std::multiset<std::string>{"limit-exceeded a"});
}

TEST_CASE("Parameters stand for literals of their type") {
  Json graph = document({{"s", toy_node("sum", {{"a", {{"parameter", "p"}}}})},
                         {"r", toy_node("ramp", {{"count", {{"parameter", "n"}}}})}});
  graph["parameters"] = {{"p", {{"type", "number"}, {"default", 2.5}, {"max", 3}}},
                         {"n", {{"type", "integer"}, {"default", 4}}},
                         {"unused", {{"type", "boolean"}, {"default", true}}}};
  CHECK(support::numbers(toy_registry, graph, "s") == std::vector<double>{12.5});
  CHECK(support::numbers(toy_registry, graph, "r").size() == 4);
  const CheckReport report = checked(toy_registry, graph, {{"p", 3}});
  CHECK(parameters_behind(report.plan, report.plan.index.at("s")) == std::set<std::string>{"p"});

  const Result<Document> read = read_document(graph, {}, toy_registry);
  const auto refused = [&](const Json& given) { return codes(resolve_parameters(*read, given).problems()); };
  CHECK(refused({{"p", 4}}) == std::multiset<std::string>{"out-of-range "});
  CHECK(refused({{"q", 4}}) == std::multiset<std::string>{"unknown-parameter "});
  CHECK(refused({{"n", 4.5}, {"p", "x"}}) == std::multiset<std::string>{"type-mismatch ", "type-mismatch "});
  graph["nodes"]["r"]["inputs"]["count"] = {{"parameter", "p"}};
  CHECK(codes(checked(toy_registry, graph).problems) == std::multiset<std::string>{"type-mismatch r.count"});
}

TEST_CASE("A bypassed node passes its first input on") {
  Json graph = document({{"r", toy_node("ramp", Json::object())},
                         {"s", toy_node("sum", {{"a", from("r")}, {"b", 100}})},
                         {"t", toy_node("sum", {{"a", from("s")}, {"b", 1}})}});
  CHECK(support::numbers(toy_registry, graph, "t") == std::vector<double>{101, 102, 103});
  graph["nodes"]["s"]["bypass"] = true;
  CHECK(support::numbers(toy_registry, graph, "t") == std::vector<double>{1, 2, 3});
  CHECK(support::numbers(toy_registry, graph, "s") == std::vector<double>{0, 1, 2});
}

TEST_CASE("All parameters before a node can change it, also through nodes that are bypassed") {
  Json graph = document({{"a", toy_node("sum", {{"a", {{"parameter", "p"}}}})},
                         {"b", toy_node("sum", {{"a", from("a")}, {"b", {{"parameter", "q"}}}})},
                         {"c", toy_node("sum", {{"a", from("b")}})},
                         {"other", toy_node("sum", {{"a", {{"parameter", "r"}}}})}});
  for (const auto* name : {"p", "q", "r"}) graph["parameters"][name] = {{"type", "number"}, {"default", 1}};
  graph["nodes"]["b"]["bypass"] = true;
  const CheckReport report = checked(toy_registry, graph);
  CHECK(parameters_behind(report.plan, report.plan.index.at("c")) == std::set<std::string>{"p"});
  graph["nodes"]["b"]["bypass"] = false;
  const CheckReport whole = checked(toy_registry, graph);
  CHECK(parameters_behind(whole.plan, whole.plan.index.at("c")) == std::set<std::string>{"p", "q"});
}

TEST_CASE("A list of problems is bounded and says how many there are besides") {
  Json inputs = Json::object();
  for (int i = 0; i < 5000; ++i) inputs["m" + std::to_string(i)] = 0;
  const CheckReport report = checked(toy_registry, document({{"s", toy_node("sum", inputs)}}));
  REQUIRE(report.problems.size() == 101);
  CHECK(report.problems.front().code == "unknown-port");
  CHECK(report.problems.back().code == "more-problems");
  CHECK(report.problems.back().detail == "there are 4900 more problems of this graph");
}

TEST_CASE("A link to a node that is not there is mended with the nearest name that is") {
  const CheckReport report =
      checked(toy_registry,
              document({{"ring", toy_node("sum", {{"a", 1}})}, {"s", toy_node("sum", {{"a", from("rong.value")}})}}));
  REQUIRE(report.problems.size() == 1);
  CHECK(report.problems[0].fix ==
        Json{{{"op", "replace"}, {"path", "/nodes/s/inputs/a/from"}, {"value", "ring.value"}}});
}

TEST_CASE("A check that is stopped ends at once") {
  const Cancel cancel;
  cancel.stop(StopReason::client_gone);
  Json nodes = Json::object();
  for (int i = 0; i < 100; ++i) nodes["n" + std::to_string(i)] = toy_node("sum", {{"a", 1}});
  const Result<Document> read = read_document(document(nodes), {}, toy_registry);
  const CheckReport report = check(toy_registry, *read, {}, Quality::final, {}, {}, {.cancel = &cancel});
  CHECK(report.plan.nodes.empty());
}
