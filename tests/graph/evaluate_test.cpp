#include <catch2/catch.hpp>
#include <thread>

#include "tests/graph/toy_registry.h"
#include "tests/support/graphs.h"

using namespace dini;
using support::document;
using support::from;
using support::toy_registry;

namespace {

Json value_node(const char* type, Json value) { return {{"type", type}, {"inputs", {{"value", std::move(value)}}}}; }

Problems failures(const Json& graph, const std::vector<std::string>& targets) {
  const CheckReport report = support::checked(toy_registry, graph);
  REQUIRE(report.problems.empty());
  std::vector<std::size_t> indices;
  for (const std::string& target : targets) indices.push_back(report.plan.index.at(target));
  Cache cache(1 << 20);
  const Job job;
  const Result<Evaluation> evaluation = evaluate(report.plan, indices, cache, job);
  REQUIRE_FALSE(evaluation.has_value());
  return evaluation.problems();
}

}  // namespace

TEST_CASE("A node runs once however many need it, and not at all when its result is cached") {
  const Json graph = document({{"a", value_node("count_runs", 4)},
                               {"b", {{"type", "sum"}, {"inputs", {{"a", from("a")}, {"b", from("a")}}}}},
                               {"c", {{"type", "sum"}, {"inputs", {{"a", from("a")}, {"b", from("b")}}}}}});
  Cache cache(1 << 20);
  const int before = toy::runs;
  CHECK(support::numbers(toy_registry, graph, "c", cache) == std::vector<double>{15});
  CHECK(toy::runs == before + 1);
  CHECK(support::numbers(toy_registry, graph, "c", cache) == std::vector<double>{15});
  CHECK(toy::runs == before + 1);
}

TEST_CASE("A chain of 64 diamonds takes time proportional to their number") {
  Json nodes = {{"n0", value_node("constant", 1)}};
  for (int i = 1; i <= 64; ++i) {
    const std::string previous = "n" + std::to_string(i - 1);
    nodes["n" + std::to_string(i)] = {{"type", "sum"}, {"inputs", {{"a", from(previous)}, {"b", from(previous)}}}};
  }
  CHECK(support::numbers(toy_registry, document(nodes), "n64") == std::vector<double>{18446744073709551616.0});
}

TEST_CASE("A chain as long as a graph may be does not exhaust the stack") {
  Json nodes = {{"n0", value_node("constant", 0)}};
  for (int i = 1; i < 2000; ++i) {
    nodes["n" + std::to_string(i)] = {{"type", "sum"},
                                      {"inputs", {{"a", from("n" + std::to_string(i - 1))}, {"b", 1}}}};
  }
  CHECK(support::numbers(toy_registry, document(nodes), "n1999") == std::vector<double>{1999});
}

TEST_CASE("Failures name the node, the port and the sample, and independent failures are all reported") {
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

TEST_CASE("Hard ranges hold for wired numbers too") {
  const Problems problems = failures(document({{"s", {{"type", "sum"}, {"inputs", {{"a", -90}, {"b", -90}}}}},
                                               {"c", value_node("constant", from("s"))}}),
                                     {"c"});
  REQUIRE(support::codes(problems) == std::multiset<std::string>{"out-of-range c.value"});
  CHECK(problems[0].detail == "value of c (Toy): got -180, accepted is -100 to 1000000");
}

TEST_CASE("A cancelled evaluation ends with the reason") {
  const CheckReport report = support::checked(toy_registry, document({{"e", value_node("endless", 1)}}));
  for (const auto& [reason, code] :
       {std::pair{StopReason::superseded, "superseded"}, {StopReason::client_gone, "client-gone"}}) {
    Cache cache(1 << 20);
    const Job job;
    std::thread stopper([&, why = reason] { job.cancel.stop(why); });
    const Result<Evaluation> evaluation = evaluate(report.plan, {0}, cache, job);
    stopper.join();
    REQUIRE_FALSE(evaluation.has_value());
    CHECK(evaluation.problems().front().code == code);
    CHECK(cache.size() == 0);
  }
  Cache cache(1 << 20);
  const Job late{Cancel(Cancel::Clock::now() + std::chrono::milliseconds(20))};
  CHECK(evaluate(report.plan, {0}, cache, late).problems().front().code == "deadline");
}

TEST_CASE("Progress announces all work before the first of it, and ends where all is done") {
  Json nodes = {{"r0", {{"type", "ramp"}, {"inputs", {{"count", 1000}}}}}};
  for (int i = 0; i < 8; ++i) {
    nodes["r" + std::to_string(i + 1)] = {{"type", "sum"},
                                          {"inputs", {{"a", from("r" + std::to_string(i))}, {"b", i}}}};
  }
  const CheckReport report = support::checked(toy_registry, document(nodes));
  const std::size_t last = report.plan.index.at("r8");
  Cache cache(1 << 28);
  const Job job;
  std::atomic<bool> over = false;
  bool went_back = false, grew = false;
  std::thread watcher([&] {
    Progress::State before;
    while (!over) {
      const Progress::State now = job.progress.state();
      went_back = went_back || now.done < before.done;
      grew = grew || (before.done > 0 && now.announced != before.announced);
      before = now;
    }
  });
  REQUIRE(evaluate(report.plan, {last}, cache, job));
  over = true;
  watcher.join();
  CHECK_FALSE(went_back);
  CHECK_FALSE(grew);
  CHECK(job.progress.state().announced > 0);
  CHECK(job.progress.state().done == job.progress.state().announced);
  const Job again;
  REQUIRE(evaluate(report.plan, {last}, cache, again));
  CHECK(again.progress.state().announced == 0);
}

TEST_CASE("A node that fails by an exception spoils nobody else's result") {
  // The ramps are large, so that they are in the middle of their loops when the other node throws.
  Json nodes = Json::object();
  for (int i = 0; i < 8; ++i) {
    const std::string n = std::to_string(i);
    nodes["r" + n] = {{"type", "ramp"}, {"inputs", {{"count", 200'000 + i}}}};
    nodes["s" + n] = {{"type", "slow_sum"}, {"inputs", {{"a", from("r" + n)}, {"b", i}}}};
  }
  for (const auto& [type, code] : {std::pair{"no_memory", "out-of-memory"}, {"throws", "internal"}}) {
    CAPTURE(type);
    nodes["bad"] = value_node(type, 1);
    const CheckReport report = support::checked(toy_registry, document(nodes));
    REQUIRE(report.problems.empty());
    std::vector<std::size_t> targets;
    for (const auto& [id, index] : report.plan.index) targets.push_back(index);
    Cache cache(1 << 28);
    const Job job;
    const Result<Evaluation> evaluation = evaluate(report.plan, targets, cache, job);
    REQUIRE_FALSE(evaluation.has_value());
    CHECK(evaluation.problems().front().code == code);
    for (int i = 0; i < 8; ++i) {
      const PlannedNode& node = report.plan.nodes[report.plan.index.at("s" + std::to_string(i))];
      const auto kept = cache.find<NodeResult>(node.fingerprint);
      if (kept == nullptr) continue;
      const Column<double>& column = *std::get<SharedColumn<double>>(kept->columns.front());
      REQUIRE(column.size() == 200'000 + static_cast<std::size_t>(i));
      for (std::size_t k = 0; k < column.size(); ++k) REQUIRE(column[k] == static_cast<double>(k) + i);
    }
    CHECK(cache.find<NodeResult>(report.plan.nodes[report.plan.index.at("bad")].fingerprint) == nullptr);
  }
}

TEST_CASE("Warnings of the nodes before it stay with a result that comes from the cache") {
  const Json graph = document({{"w", value_node("warns", 3)}, {"c", value_node("constant", from("w"))}});
  const CheckReport report = support::checked(toy_registry, graph);
  const std::size_t last = report.plan.index.at("c");
  Cache cache(1 << 20);
  const Job job;
  CHECK_FALSE(find_evaluation(report.plan, {last}, cache));
  REQUIRE(evaluate(report.plan, {last}, cache, job));
  const std::optional<Evaluation> found = find_evaluation(report.plan, {last}, cache);
  REQUIRE(found);
  CHECK(found->runs.size() == 1);
  const NodeRun* run = found->run(report.plan.nodes[last]);
  REQUIRE(run != nullptr);
  CHECK(run->cached);
  REQUIRE(run->result->warnings.size() == 1);
  CHECK(run->result->warnings[0]->fingerprint == report.plan.nodes[report.plan.index.at("w")].fingerprint);
  CHECK(run->result->warnings[0]->warnings[0].code == "toy");
}

TEST_CASE("Equal nodes of one graph are computed once") {
  const Json graph = document({{"a", value_node("count_runs", 5)},
                               {"b", value_node("count_runs", 5)},
                               {"c", {{"type", "sum"}, {"inputs", {{"a", from("a")}, {"b", from("b")}}}}}});
  const int before = toy::runs;
  CHECK(support::numbers(toy_registry, graph, "c") == std::vector<double>{12});
  CHECK(toy::runs == before + 1);
}

TEST_CASE("The cache forgets the least recently used results first and stays within its budget") {
  Cache cache(1500);
  const auto insert = [&](std::uint8_t key, std::size_t bytes) {
    cache.insert<int>({key}, std::make_shared<const int>(key), bytes);
  };
  const auto find = [&](std::uint8_t key) { return cache.find<int>({key}); };
  for (std::uint8_t i = 0; i < 5; ++i) insert(i, 8);
  CHECK(find(0) != nullptr);
  insert(5, 8);
  REQUIRE(find(0) != nullptr);
  CHECK(*find(0) == 0);
  CHECK(find(1) == nullptr);
  CHECK(cache.bytes() <= 1500);
  CHECK(cache.evictions() == 1);
  insert(9, 8000);
  CHECK(find(9) == nullptr);
  CHECK(find(0) != nullptr);
  insert(0, 8);
  CHECK(cache.size() == 5);
}
