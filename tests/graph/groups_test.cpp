#include "graph/groups.h"

#include <catch2/catch.hpp>

#include "tests/graph/toy_registry.h"
#include "tests/support/graphs.h"

using namespace dini;
using support::from;
using support::make;
using support::toy_registry;

namespace {

Json input(const std::string& name) { return {{"input", name}}; }

Json grouped(Json groups, Json nodes) {
  return {{"format", 2}, {"groups", std::move(groups)}, {"nodes", std::move(nodes)}};
}

Json flat(Json nodes) { return {{"format", 2}, {"nodes", std::move(nodes)}}; }

/// a + 2 b.
Json weighted() {
  return {{"inputs", {{{"name", "a"}}, {{"name", "b"}, {"default", 3}}}},
          {"outputs", {{{"name", "value"}, {"from", "sum"}}, {{"name", "twice"}, {"from", "twice.value"}}}},
          {"nodes",
           {{"twice", make("doubled", {{"value", input("b")}})},
            {"sum", make("sum", {{"a", input("a")}, {"b", from("twice")}})}}}};
}

/// Two of them in a row, in a group of their own.
Json chain() {
  return {{"inputs", {{{"name", "start"}, {"default", 1}}, {{"name", "step"}}}},
          {"outputs", {{{"name", "end"}, {"from", "second"}}}},
          {"nodes",
           {{"first", make("group/weighted", {{"a", input("start")}, {"b", input("step")}})},
            {"second", make("group/weighted", {{"a", from("first")}, {"b", input("step")}})}}}};
}

Result<Document> read(const Json& json, const Limits& limits = {}) {
  Result<Document> document = read_document(json, limits, toy_registry);
  if (!document) return document;
  return expanded(*std::move(document), limits, toy_registry);
}

/// "code pointer" of all problems, those of the check included.
std::multiset<std::string> problems(const Json& json, const Limits& limits = {}) {
  const Result<Document> document = read(json, limits);
  std::multiset<std::string> all;
  const auto add = [&](const Problems& found) {
    for (const Problem& problem : found) all.insert(problem.code + " " + problem.pointer.value_or("nowhere"));
  };
  if (!document) {
    add(document.problems());
  } else {
    add(check(toy_registry, *document, usual_parameters(*document), Quality::final, limits).problems);
  }
  return all;
}

using Found = std::multiset<std::string>;

}  // namespace

TEST_CASE("A document with groups is written as it was read") {
  Json json = grouped({{"weighted", weighted()}, {"chain", chain()}}, {{"c", make("group/chain", {{"step", 2}})}});
  json["groups"]["weighted"]["label"] = "Weighted sum";
  json["groups"]["weighted"]["inputs"][0]["description"] = "The first.";
  const Result<Document> document = read_document(json, Limits(), toy_registry);
  REQUIRE(document);
  CHECK(write_document(*document) == json);
}

TEST_CASE("A document with nested groups becomes its flat form") {
  Json json = grouped({{"weighted", weighted()}, {"chain", chain()}},
                      {{"n", make("constant", {{"value", 5}})},
                       {"c", make("group/chain", {{"step", from("n")}})},
                       {"end", make("sum", {{"a", from("c")}, {"b", from("c.end")}})}});
  const Result<Document> document = read(json);
  REQUIRE(document);
  const Json wanted = flat({{"n", make("constant", {{"value", 5}})},
                            {"c/first/twice", make("doubled", {{"value", from("n")}})},
                            {"c/first/sum", make("sum", {{"a", 1}, {"b", from("c/first/twice")}})},
                            {"c/second/twice", make("doubled", {{"value", from("n")}})},
                            {"c/second/sum", make("sum", {{"a", from("c/first/sum")}, {"b", from("c/second/twice")}})},
                            {"end", make("sum", {{"a", from("c/second/sum")}, {"b", from("c/second/sum")}})}});
  CHECK(write_document(*document) == wanted);
  const Result<Document> same = read(wanted);
  REQUIRE(same);
  const CheckReport ours = check(toy_registry, *document, {}, Quality::final, {});
  const CheckReport theirs = check(toy_registry, *same, {}, Quality::final, {});
  REQUIRE(ours.problems.empty());
  REQUIRE(ours.plan.nodes.size() == 6);
  for (std::size_t k = 0; k < ours.plan.nodes.size(); ++k) {
    CHECK(ours.plan.nodes[k].id == theirs.plan.nodes[k].id);
    CHECK(ours.plan.nodes[k].fingerprint == theirs.plan.nodes[k].fingerprint);
  }
}

TEST_CASE("An instance that leaves an input out gives the default, or else that of the node") {
  const Result<Document> document =
      read(grouped({{"weighted", weighted()}}, {{"w", make("group/weighted", {{"a", 1}})}}));
  REQUIRE(document);
  CHECK(std::get<WrittenLiteral>(document->nodes.at("w/twice").inputs.at("value").items[0]).written == 3);
  Json group = weighted();
  group["nodes"]["sum"]["inputs"] = {{"a", 1}, {"b", input("a")}};
  const Result<Document> other = read(grouped({{"weighted", group}}, {{"w", make("group/weighted")}}));
  REQUIRE(other);
  CHECK_FALSE(other->nodes.at("w/sum").inputs.contains("b"));
}

TEST_CASE("Lists given to a group take the place of its input") {
  const Json group = {{"inputs", {{{"name", "more"}}, {{"name", "one"}, {"default", 7}}}},
                      {"outputs", {{{"name", "items"}, {"from", "list"}}}},
                      {"nodes",
                       {{"list", make("list", {{"items", {from("n"), input("more"), input("one")}}})},
                        {"alone", make("list", {{"items", input("more")}})},
                        {"n", make("constant")}}}};
  const auto items_of = [&](const Json& given, const std::string& node) {
    const Result<Document> document =
        read(grouped({{"g", group}}, {{"a", make("constant")}, {"i", make("group/g", {{"more", given}})}}));
    REQUIRE(document);
    return write_document(*document)["nodes"][node]["inputs"]["items"];
  };
  CHECK(items_of({from("a"), 2}, "i/list") == Json{from("i/n"), from("a"), 2, 7});
  CHECK(items_of({1, 2}, "i/list") == Json{from("i/n"), 1, 2, 7});
  CHECK(items_of({1, 2}, "i/alone") == Json{1, 2});
  CHECK(items_of(from("a"), "i/alone") == from("a"));
}

TEST_CASE("Axes that are called after nodes of a group are called after their paths") {
  const Json group = {{"outputs", {{{"name", "value"}, {"from", "total"}}}},
                      {"inputs", {{{"name", "along"}, {"default", "k"}}, {{"name", "values"}}}},
                      {"nodes",
                       {{"k", make("ramp")},
                        {"both", make("sum", {{"a", from("k")}, {"b", input("values")}})},
                        {"total", make("total", {{"values", from("both")}, {"over", input("along")}})}}}};
  const Json nodes = {{"k", make("ramp", {{"count", 4}})},
                      {"inner", make("group/g", {{"values", from("k")}})},
                      {"outer", make("group/g", {{"values", from("k")}, {"along", "k"}})}};
  const Result<Document> document = read(grouped({{"g", group}}, nodes));
  REQUIRE(document);
  const CheckReport report = check(toy_registry, *document, {}, Quality::final, {});
  REQUIRE(report.problems.empty());
  const auto axis_of = [&](const std::string& id) {
    return report.plan.nodes[report.plan.index.at(id)].outputs[0].axes.at(0).name;
  };
  CHECK(axis_of("inner/total") == "k");
  CHECK(axis_of("outer/total") == "outer/k");
}

TEST_CASE("A bypassed instance passes on what its first input is linked to") {
  const auto with = [](const Json& w, const Json& v) {
    return grouped({{"weighted", weighted()}},
                   {{"n", make("constant")}, {"w", w}, {"v", v}, {"s", make("sum", {{"a", from("w.twice")}})}});
  };
  Json w = make("group/weighted", {{"a", from("n")}}), v = make("group/weighted", {{"a", from("w")}});
  w["bypass"] = true;
  const Result<Document> document = read(with(w, v));
  REQUIRE(document);
  CHECK(write_document(*document)["nodes"]["s"]["inputs"]["a"] == from("n"));
  CHECK(write_document(*document)["nodes"]["v/sum"]["inputs"]["a"] == from("n"));
  w["inputs"]["a"] = 1;
  CHECK(problems(with(w, v)) == Found{"required-input-missing /nodes/w"});
  w["inputs"]["a"] = from("v");
  v["bypass"] = true;
  CHECK(problems(with(w, v)).count("graph-has-cycle /nodes/s/inputs/a") == 1);
}

TEST_CASE("Problems within groups point at what was written") {
  Json json = grouped({{"weighted", weighted()}}, {{"w", make("group/weighted", {{"a", "one"}})}});
  CHECK(problems(json) == Found{"type-mismatch /nodes/w/inputs/a"});
  json["nodes"]["w"]["inputs"] = {{"a", 1}};
  json["groups"]["weighted"]["inputs"][1]["default"] = "three";
  CHECK(problems(json) == Found{"type-mismatch /groups/weighted/inputs/1/default"});
  json["groups"]["weighted"] = weighted();
  json["nodes"]["w"]["inputs"] = Json::object();
  CHECK(problems(json) == Found{"required-input-missing /nodes/w/inputs/a"});
  json["groups"]["weighted"]["nodes"]["twice"]["inputs"]["value"] = from("odd");
  json["groups"]["weighted"]["nodes"]["odd"] = make("constant", {{"value", -200}});
  json["nodes"]["w"]["inputs"] = {{"a", 1}};
  const Result<Document> document = read(json);
  REQUIRE(document);
  const Problems found = check(toy_registry, *document, {}, Quality::final, {}).problems;
  REQUIRE(found.size() == 1);
  CHECK(found[0].node == "w/odd");
  CHECK(found[0].pointer == "/groups/weighted/nodes/odd/inputs/value");
  CHECK(found[0].fix[0]["path"] == "/groups/weighted/nodes/odd/inputs/value");
}

TEST_CASE("What is wrong with a definition is said once, and where it is not used as well") {
  Json group = weighted();
  group["nodes"]["twice"]["inputs"] = {{"value", input("c")}, {"offest", 1}};
  group["nodes"]["sum"]["inputs"] = {{"a", {{"parameter", "p"}}}};
  CHECK(problems(grouped({{"g", group}}, Json::object())) == Found{"unknown-parameter /groups/g/nodes/sum/inputs/a"});
  group["nodes"]["sum"] = make("sume", {{"a", from("twise")}});
  group["outputs"][1]["from"] = "twice.valeu";
  CHECK(problems(grouped({{"g", group}}, {{"a", make("group/g")}, {"b", make("group/g")}})) ==
        Found{"unknown-port /groups/g/nodes/twice/inputs/value", "unknown-port /groups/g/nodes/twice/inputs/offest",
              "unknown-node-type /groups/g/nodes/sum/type", "dangling-link /groups/g/nodes/sum/inputs/a",
              "dangling-link /groups/g/outputs/1/from"});
  CHECK(problems(grouped(
            {{"g", {{"nodes", 3}, {"inputs", {{{"name", "1"}}, {{"nam", "x"}}}}, {"outputs", {{{"name", "o"}}}}}}},
            Json::object())) == Found{"type-mismatch /groups/g/nodes", "invalid-id /groups/g/inputs/0/name",
                                      "unknown-member /groups/g/inputs/1/nam",
                                      "required-member-missing /groups/g/outputs/0"});
}

TEST_CASE("Instances of unknown groups, with unknown inputs or outputs, are refused") {
  const Json nodes = {{"w", make("group/weighted", {{"c", 1}})},
                      {"u", make("group/wheighted")},
                      {"s", make("sum", {{"a", from("w.valeu")}, {"b", from("ww")}})},
                      {"t", make("sum", {{"a", from("w/sum")}})}};
  CHECK(problems(grouped({{"weighted", weighted()}}, nodes)) ==
        Found{"unknown-port /nodes/w/inputs/c", "unknown-node-type /nodes/u/type", "dangling-link /nodes/s/inputs/a",
              "dangling-link /nodes/s/inputs/b", "dangling-link /nodes/t/inputs/a"});
  CHECK(problems(flat({{"u", make("group/weighted")}})) == Found{"unknown-node-type /nodes/u/type"});
}

TEST_CASE("A group that contains itself is refused, however far down") {
  Json self = weighted(), other = weighted();
  self["nodes"]["again"] = make("group/self");
  CHECK(problems(grouped({{"self", self}}, Json::object())) == Found{"recursive-group /groups/self/nodes/again/type"});
  self["nodes"]["again"] = make("group/other");
  other["nodes"]["back"] = make("group/self");
  CHECK(problems(grouped({{"self", self}, {"other", other}}, Json::object())).size() == 1);
}

TEST_CASE("Limits count the nodes of groups as often as they stand, before they are made") {
  Json groups = {{"g0", weighted()}};
  for (int k = 1; k < 16; ++k) {
    Json nodes;
    for (int i = 0; i < 10; ++i)
      nodes["i" + std::to_string(i)] = make("group/g" + std::to_string(k - 1), Json::object());
    groups["g" + std::to_string(k)] = {{"nodes", nodes}};
  }
  CHECK(problems(grouped(groups, {{"all", make("group/g15")}})) == Found{"limit-exceeded /nodes"});
  CHECK(problems(grouped(groups, {{"few", make("group/g2")}})).count("limit-exceeded /nodes") == 0);
  groups["g16"] = {{"nodes", {{"i", make("group/g15")}}}};
  CHECK(problems(grouped(groups, Json::object())) == Found{"limit-exceeded /groups/g16"});
  const Json empty = {{"nodes", Json::object()}};
  Json twins = {{"g0", empty}};
  for (int k = 1; k < 16; ++k) {
    const Json inner = make("group/g" + std::to_string(k - 1));
    twins["g" + std::to_string(k)] = {{"nodes", {{"a", inner}, {"b", inner}}}};
  }
  CHECK(problems(grouped(twins, {{"all", make("group/g15")}})) == Found{"limit-exceeded /nodes"});
  Json wide = {{"inputs", {{{"name", "more"}}}}, {"nodes", Json::object()}};
  for (int k = 0; k < 100; ++k) wide["nodes"]["l" + std::to_string(k)] = make("list", {{"items", input("more")}});
  const Json links = std::vector<Json>(100, from("n"));
  CHECK(problems(grouped({{"wide", wide}}, {{"n", make("constant")}, {"w", make("group/wide", {{"more", links}})}})) ==
        Found{"limit-exceeded /nodes"});
}

TEST_CASE("What groups pass on is counted where it arrives nowhere, and literals for every copy") {
  Json groups = Json::object();
  const std::vector<Json> ten(10, input("more"));
  for (int k = 0; k < 16; ++k) {
    const Json node =
        k == 0 ? make("list", {{"items", ten}}) : make("group/g" + std::to_string(k - 1), {{"more", ten}});
    groups["g" + std::to_string(k)] = {{"inputs", {{{"name", "more"}}}}, {"nodes", {{"i", node}}}};
  }
  CHECK(problems(grouped(groups, {{"all", make("group/g15")}})) == Found{"limit-exceeded /nodes"});
  CHECK(problems(grouped(groups, {{"all", make("group/g15", {{"more", Json::array()}})}})) ==
        Found{"limit-exceeded /nodes"});
  Json wide = {{"inputs", {{{"name", "a"}}}}, {"nodes", Json::object()}};
  for (int k = 0; k < 1000; ++k) wide["nodes"]["s" + std::to_string(k)] = make("sum", {{"a", input("a")}, {"b", 1}});
  const auto given = [&](const Json& a) { return grouped({{"wide", wide}}, {{"w", make("group/wide", {{"a", a}})}}); };
  CHECK(problems(given(1)).empty());
  CHECK(problems(given(std::vector<int>(500, 1))) == Found{"limit-exceeded /nodes"});
  CHECK(problems(given(std::string(2000, 'x'))) == Found{"limit-exceeded /nodes"});
  wide["nodes"]["s0"]["inputs"]["b"] = std::string(60'000, 'x');
  Json often = Json::object();
  for (int k = 0; k < 20; ++k) often["w" + std::to_string(k)] = make("group/wide", {{"a", 1}});
  for (int k = 1; k < 1000; ++k) wide["nodes"].erase("s" + std::to_string(k));
  CHECK(problems(grouped({{"wide", wide}}, often)) == Found{"limit-exceeded /nodes"});
}

TEST_CASE("A group has so many inputs and outputs and no more") {
  Json group = weighted();
  for (const char* const sockets : {"inputs", "outputs"}) {
    const Json first = group[sockets][0];
    group[sockets] = std::vector<Json>(256, first);
    for (int k = 1; k < 256; ++k) group[sockets][k]["name"] = "s" + std::to_string(k);
  }
  group["nodes"]["twice"]["inputs"]["value"] = input("s7");
  const Json nodes = {{"w", make("group/g", {{"a", 1}, {"s7", 2}})}};
  CHECK(problems(grouped({{"g", group}}, nodes)).empty());
  group["inputs"].push_back({{"name", "more"}});
  CHECK(problems(grouped({{"g", group}}, nodes)) == Found{"limit-exceeded /groups/g/inputs"});
  group["inputs"].erase(256);
  group["outputs"].push_back({{"name", "more"}, {"from", "sum"}});
  CHECK(problems(grouped({{"g", group}}, nodes)) == Found{"limit-exceeded /groups/g/outputs"});
}

TEST_CASE("A bypassed instance that many items of a list lead to is met many times, and in no cycle") {
  const Json lists = {{"inputs", {{{"name", "more"}}}}, {"nodes", {{"l", make("list", {{"items", input("more")}})}}}};
  Json bypassed = make("group/weighted", {{"a", from("n")}});
  bypassed["bypass"] = true;
  const Result<Document> document =
      read(grouped({{"weighted", weighted()}, {"lists", lists}},
                   {{"n", make("constant")},
                    {"w", bypassed},
                    {"i", make("group/lists", {{"more", std::vector<Json>(10, from("w"))}})}}));
  REQUIRE(document);
  CHECK(write_document(*document)["nodes"]["i/l"]["inputs"]["items"] == Json(std::vector<Json>(10, from("n"))));
}

TEST_CASE("One output of an instance may go into another input of it where that makes no cycle of nodes") {
  const Json apart = {
      {"inputs", {{{"name", "a"}}, {{"name", "b"}}}},
      {"outputs", {{{"name", "x"}, {"from", "first"}}, {{"name", "y"}, {"from", "second"}}}},
      {"nodes",
       {{"first", make("doubled", {{"value", input("a")}})}, {"second", make("doubled", {{"value", input("b")}})}}}};
  const auto with = [&](const Json& inputs) {
    return problems(grouped({{"g", apart}}, {{"n", make("constant")}, {"w", make("group/g", inputs)}}));
  };
  CHECK(with({{"a", from("n")}, {"b", from("w.x")}}).empty());
  CHECK(with({{"a", from("w.y")}, {"b", from("w.x")}}).size() == 1);
  CHECK(with({{"a", from("n")}, {"b", from("w.y")}}) == Found{"graph-has-cycle /groups/g/nodes/second"});
}

TEST_CASE("Groups and paths are of format 2, and documents of format 1 say so") {
  Json json = grouped({{"weighted", weighted()}}, {{"w", make("group/weighted", {{"a", 1}})}});
  json["format"] = 1;
  CHECK(problems(json) == Found{"unsupported-format /format"});
  CHECK(problems({{"format", 1}, {"nodes", {{"w/sum", make("constant")}}}}) == Found{"invalid-id /nodes/w~1sum"});
  CHECK(problems(flat({{"w//sum", make("constant")}, {"/a", make("constant")}, {"a/", make("constant")}})) ==
        Found{"invalid-id /nodes/w~1~1sum", "invalid-id /nodes/~1a", "invalid-id /nodes/a~1"});
  json["format"] = 2;
  json["nodes"]["w/sum"] = make("constant");
  CHECK(problems(json) == Found{"invalid-id /nodes/w~1sum"});
}

TEST_CASE("What stands at the outputs of an instance is known by its id") {
  const Result<Document> document = read(grouped({{"weighted", weighted()}, {"chain", chain()}},
                                                 {{"c", make("group/chain", {{"step", 1}})}, {"n", make("constant")}}));
  REQUIRE(document);
  using Places = std::vector<std::string>;
  CHECK(places_behind(*document, "c") == Places{"c/second/sum"});
  CHECK(places_behind(*document, "c.end") == Places{"c/second/sum"});
  CHECK(places_behind(*document, "c/first") == Places{"c/first/sum", "c/first/twice.value"});
  CHECK(places_behind(*document, "c.start") == Places{"c.start"});
  CHECK(places_behind(*document, "n.value") == Places{"n.value"});
}
