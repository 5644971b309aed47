#include <catch2/catch.hpp>
#include <thread>

#include "tests/support/graphs.h"
#include "tests/support/toy_nodes.h"

using namespace dini;
using support::document;

namespace {

const Registry registry = toy::registry();

Json value_node(const char* type, Json value) { return {{"type", type}, {"inputs", {{"value", std::move(value)}}}}; }

Json from(const std::string& link) { return {{"from", link}}; }

Problems failures(const Json& graph, const std::vector<std::string>& targets) {
  const CheckReport report = support::checked(registry, graph);
  REQUIRE(report.problems.empty());
  std::vector<std::size_t> indices;
  for (const std::string& target : targets) indices.push_back(report.plan.index.at(target));
  Cache cache(1 << 20);
  const Cancel cancel;
  const Result<Evaluation> evaluation = evaluate(report.plan, indices, cache, cancel);
  REQUIRE_FALSE(evaluation.has_value());
  return evaluation.problems();
}

}  // namespace

TEST_CASE("a node runs once however many need it, and not at all when its result is cached") {
  const Json graph = document({{"a", value_node("count_runs", 4)},
                               {"b", {{"type", "sum"}, {"inputs", {{"a", from("a")}, {"b", from("a")}}}}},
                               {"c", {{"type", "sum"}, {"inputs", {{"a", from("a")}, {"b", from("b")}}}}}});
  Cache cache(1 << 20);
  const int before = toy::runs;
  CHECK(support::numbers(registry, graph, "c", cache) == std::vector<double>{15});
  CHECK(toy::runs == before + 1);
  CHECK(support::numbers(registry, graph, "c", cache) == std::vector<double>{15});
  CHECK(toy::runs == before + 1);
}

TEST_CASE("64 diamonds in a chain take time proportional to their number") {
  Json nodes = {{"n0", value_node("constant", 1)}};
  for (int i = 1; i <= 64; ++i) {
    const std::string previous = "n" + std::to_string(i - 1);
    nodes["n" + std::to_string(i)] = {{"type", "sum"}, {"inputs", {{"a", from(previous)}, {"b", from(previous)}}}};
  }
  CHECK(support::numbers(registry, document(nodes), "n64") == std::vector<double>{18446744073709551616.0});
}

TEST_CASE("a chain as long as a graph may be does not exhaust the stack") {
  Json nodes = {{"n0", value_node("constant", 0)}};
  for (int i = 1; i < 2000; ++i) {
    nodes["n" + std::to_string(i)] = {{"type", "sum"},
                                      {"inputs", {{"a", from("n" + std::to_string(i - 1))}, {"b", 1}}}};
  }
  CHECK(support::numbers(registry, document(nodes), "n1999") == std::vector<double>{1999});
}

TEST_CASE("failures name the node, the port and the sample; independent failures are all reported") {
  const Problems problems = failures(document({{"r", {{"type", "ramp"}, {"inputs", {{"count", 5}}}}},
                                               {"m", {{"type", "sum"}, {"inputs", {{"a", from("r")}, {"b", -4}}}}},
                                               {"root", value_node("root", from("m"))},
                                               {"behind", value_node("constant", from("root"))},
                                               {"inverse", value_node("reciprocal", from("m"))}}),
                                     {"behind", "inverse"});
  CHECK(support::codes(problems) == std::multiset<std::string>{"degenerate root.value", "non-finite inverse"});
  CHECK(std::any_of(problems.begin(), problems.end(),
                    [](const Problem& p) { return p.detail == "no root of a negative number at index 0 of axis r"; }));
  CHECK(std::any_of(problems.begin(), problems.end(),
                    [](const Problem& p) { return p.detail.ends_with("number at index 4 of axis r"); }));
}

TEST_CASE("hard ranges hold for wired numbers too") {
  const Problems problems = failures(document({{"s", {{"type", "sum"}, {"inputs", {{"a", -90}, {"b", -90}}}}},
                                               {"c", value_node("constant", from("s"))}}),
                                     {"c"});
  REQUIRE(support::codes(problems) == std::multiset<std::string>{"out-of-range c.value"});
  CHECK(problems[0].detail == "value of c (Toy): got -180, accepted is -100 to 1000000");
}

TEST_CASE("a cancelled evaluation ends with the reason") {
  const CheckReport report = support::checked(registry, document({{"e", value_node("endless", 1)}}));
  for (const auto& [reason, code] :
       {std::pair{StopReason::superseded, "superseded"}, {StopReason::client_gone, "client-gone"}}) {
    Cache cache(1 << 20);
    const Cancel cancel;
    std::thread stopper([&, why = reason] { cancel.stop(why); });
    const Result<Evaluation> evaluation = evaluate(report.plan, {0}, cache, cancel);
    stopper.join();
    REQUIRE_FALSE(evaluation.has_value());
    CHECK(evaluation.problems().front().code == code);
    CHECK(cache.size() == 0);
  }
  Cache cache(1 << 20);
  const Cancel late(Cancel::Clock::now() + std::chrono::milliseconds(20));
  CHECK(evaluate(report.plan, {0}, cache, late).problems().front().code == "deadline");
}

TEST_CASE("the cache forgets the least recently used results first and stays within its budget") {
  Cache cache(1500);
  const auto result = [] { return std::make_shared<NodeResult>(NodeResult{{single_column(1.0)}, {}}); };
  for (std::uint8_t i = 0; i < 5; ++i) cache.insert({i}, result());
  CHECK(cache.find({0}) != nullptr);
  cache.insert({5}, result());
  CHECK(cache.find({0}) != nullptr);
  CHECK(cache.find({1}) == nullptr);
  CHECK(cache.bytes() <= 1500);
  const auto large =
      std::make_shared<NodeResult>(NodeResult{{SharedColumn<double>(std::make_shared<Column<double>>(1000))}, {}});
  cache.insert({9}, large);
  CHECK(cache.find({9}) == nullptr);
  CHECK(cache.find({0}) != nullptr);
}
