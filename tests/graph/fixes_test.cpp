// Every fix is a JSON Patch that mends its problem.

#include <catch2/catch.hpp>

#include "tests/support/graphs.h"
#include "tests/support/toy_nodes.h"

using namespace dini;
using namespace dini::support;

namespace {

const Registry registry = toy::registry();

Json mended(const Json& graph, const Json& fix) { return graph.patch(fix); }

/// The only problem of a graph, whose fix must leave no problem with that code.
Problem mended_problem(const Json& nodes, const Json& parameters = Json::object()) {
  Json graph = document(nodes);
  if (!parameters.empty()) graph["parameters"] = parameters;
  const CheckReport report = checked(registry, graph);
  REQUIRE(report.problems.size() == 1);
  const Problem problem = report.problems.front();
  CAPTURE(problem.detail, problem.fix);
  REQUIRE(problem.fix.is_array());
  for (const Problem& left : checked(registry, mended(graph, problem.fix)).problems) CHECK(left.code != problem.code);
  return problem;
}

std::string only_path(const Problem& problem) {
  return problem.fix[0]["op"].get<std::string>() + " " + problem.fix[0]["path"].get<std::string>();
}

}  // namespace

TEST_CASE("A missing input gets a neutral literal, also in a node without inputs") {
  const Problem bare = mended_problem({{"s", make("sum")}});
  CHECK(bare.code == "required-input-missing");
  CHECK(bare.fix == Json::parse(R"([{"op": "add", "path": "/nodes/s/inputs", "value": {"a": 0}}])"));
  CHECK(only_path(mended_problem({{"s", make("sum", {{"b", 1}})}})) == "add /nodes/s/inputs/a");
  CHECK(mended_problem({{"s", {{"type", "shifted"}}}}).fix[0]["value"] == Json({{"point", {0, 0, 0}}}));
  CHECK(mended_problem({{"t", make("total", {{"values", Json::array()}})}}).fix[0]["value"] == Json::array({0}));
}

TEST_CASE("Literals out of range or no choice go to the nearest that is accepted, in lists too") {
  CHECK(mended_problem({{"c", make("constant", {{"value", 1e9}})}}).fix[0]["value"] == 1e6);
  CHECK(mended_problem({{"r", make("ramp", {{"count", -7}})}}).fix[0]["value"] == 1);
  const Problem word = mended_problem({{"c", make("chooser", {{"word", "secnd"}})}});
  CHECK(word.code == "not-in-choices");
  CHECK(word.fix[0]["value"] == "second");
  CHECK(mended_problem({{"c", make("chooser", {{"word", "elephant"}})}}).fix[0]["value"] == "first");
}

TEST_CASE("Links that lead nowhere are taken out, wrong outputs and names go to the nearest") {
  const Json a = make("constant");
  CHECK(only_path(mended_problem({{"s", make("sum", {{"a", 1}, {"b", from("gone")}})}})) == "remove /nodes/s/inputs/b");
  CHECK(only_path(mended_problem({{"a", a}, {"t", make("total", {{"values", {from("a"), from("gone")}}})}})) ==
        "remove /nodes/t/inputs/values/1");
  CHECK(mended_problem({{"a", a}, {"s", make("sum", {{"a", from("a.valeu")}})}}).fix[0]["value"] == "a.value");
  CHECK(only_path(mended_problem({{"a", a}, {"t", make("total", {{"values", {from("a"), from("a.other")}}})}})) ==
        "remove /nodes/t/inputs/values/1");
  CHECK(mended_problem({{"s", make("sum", {{"a", {{"parameter", "reech"}}}})}},
                       {{"reach", {{"type", "number"}, {"default", 1}}}})
            .fix[0]["value"] == "reach");
  CHECK(mended_problem({{"s", make("summ", {{"a", 1}})}}).fix[0]["value"] == "sum");
  CHECK(only_path(mended_problem({{"s", make("sum", {{"a", 1}, {"qqqqq", 2}})}})) == "remove /nodes/s/inputs/qqqqq");
}

TEST_CASE("One link less breaks a cycle, and every cycle is reported") {
  mended_problem({{"a", make("sum", {{"a", from("b")}})}, {"b", make("sum", {{"a", from("a")}})}});
  const Problem both = mended_problem({{"a", make("sum", {{"a", from("a")}, {"b", from("a")}})}});
  CHECK(both.fix.size() == 2);
  const Problem listed =
      mended_problem({{"c", make("constant")}, {"t", make("total", {{"values", {from("t"), from("c"), from("t")}}})}});
  CHECK(listed.fix == Json::parse(R"([{"op": "remove", "path": "/nodes/t/inputs/values/2"},
                                      {"op": "remove", "path": "/nodes/t/inputs/values/0"}])"));
  const CheckReport report = checked(registry, document({{"a", make("sum", {{"a", from("a")}})},
                                                         {"b", make("sum", {{"a", from("c")}, {"b", from("a")}})},
                                                         {"c", make("sum", {{"a", from("b")}})},
                                                         {"d", make("sum", {{"a", from("c")}})}}));
  CHECK(codes(report.problems) == std::multiset<std::string>{"graph-has-cycle a", "graph-has-cycle c"});
  CHECK(report.blocked == std::vector<std::string>{"b", "d"});
}

TEST_CASE("Values of parameters are mended where the request gives them") {
  Json graph = document({{"c", make("constant")}});
  graph["parameters"] = {{"reach", {{"type", "number"}, {"default", 1}, {"max", 3}}}};
  const Result<Document> read = read_document(graph, {}, registry);
  REQUIRE(read);
  const auto fix = [&](const Json& given) { return resolve_parameters(*read, given).problems().front().fix; };
  CHECK(Json{{"parameters", {{"reach", 9}}}}.patch(fix({{"reach", 9}}))["parameters"] == Json({{"reach", 3}}));
  CHECK(Json{{"parameters", {{"reech", 2}}}}.patch(fix({{"reech", 2}}))["parameters"] == Json({{"reach", 2}}));
  CHECK(fix({{"else", 2}})[0]["op"] == "remove");
  graph["parameters"]["reach"]["default"] = 5;
  const Result<Document> wrong = read_document(graph, {}, registry);
  REQUIRE_FALSE(wrong);
  CHECK(mended(graph, wrong.problems().front().fix)["parameters"]["reach"]["default"] == 3);
}

TEST_CASE("Wires are told as far as they follow, also of broken nodes and behind them") {
  const CheckReport report = checked(registry, document({{"r", make("ramp", {{"count", 4}})},
                                                         {"bad", make("sum", {{"a", from("r")}, {"b", "x"}})},
                                                         {"behind", make("sum", {{"a", from("bad")}})},
                                                         {"also", make("sum", {{"a", from("bad")}, {"b", "y"}})},
                                                         {"lacking", make("shifted")},
                                                         {"unknown", make("nothing")},
                                                         {"lost", make("sum", {{"a", from("unknown")}})}}));
  const auto axes = [&](const std::string& id) { return report.plan.nodes[report.plan.index.at(id)].outputs[0].axes; };
  CHECK(axes("bad") == Axes{{"r", 4, false}});
  CHECK(axes("behind") == Axes{{"r", 4, false}});
  CHECK(axes("lacking").empty());
  CHECK_FALSE(report.plan.index.contains("lost"));
  CHECK(report.blocked == std::vector<std::string>{"behind", "lost"});
  CHECK(codes(report.problems) == std::multiset<std::string>{"required-input-missing lacking.point",
                                                             "type-mismatch also.b", "type-mismatch bad.b",
                                                             "unknown-node-type unknown"});
}

TEST_CASE("What is not asked for is checked apart") {
  const Json graph = document({{"a", make("constant")},
                               {"b", make("sum", {{"a", from("a")}})},
                               {"c", make("sum", {{"a", from("gone")}})},
                               {"d", make("sum", {{"a", from("c")}})}});
  const Result<Document> read = read_document(graph, {}, registry);
  REQUIRE(read);
  const CheckReport report = check(registry, *read, {}, Quality::final, {}, {}, {{"b"}, true});
  CHECK(report.problems.empty());
  CHECK(report.blocked.empty());
  CHECK(codes(report.elsewhere) == std::multiset<std::string>{"dangling-link c.a"});
  CHECK(check(registry, *read, {}, Quality::final, {}, {}, {{"d"}, true}).blocked == std::vector<std::string>{"d"});
}
