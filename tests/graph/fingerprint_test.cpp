#include <catch2/catch.hpp>

#include "tests/graph/toy_registry.h"
#include "tests/support/graphs.h"

using namespace dini;
using support::document;
using support::toy_registry;

namespace {

Digest key(const Json& graph, const std::string& node) {
  const CheckReport report = support::checked(toy_registry, graph);
  REQUIRE(report.problems.empty());
  return report.plan.nodes[report.plan.index.at(node)].fingerprint;
}

Json two_ramps(const char* a, const char* b, int size_b, const char* axis_b) {
  return document({{a, {{"type", "ramp"}, {"inputs", {{"count", 3}}}}},
                   {b, {{"type", "ramp"}, {"inputs", {{"count", size_b}, {"axis", axis_b}}}}},
                   {"s", {{"type", "sum"}, {"inputs", {{"a", {{"from", a}}}, {"b", {{"from", b}}}}}}}});
}

}  // namespace

TEST_CASE("Ids, names of axes and ui do not count") {
  Json graph = two_ramps("a", "b", 3, "");
  const Digest plain = key(graph, "s");
  CHECK(key(two_ramps("x", "y", 3, "other"), "s") == plain);
  graph["ui"] = {{"nodes", {{"a", {{"x", 3}}}}}};
  graph["meta"] = {{"title", "T"}};
  CHECK(key(graph, "s") == plain);
}

TEST_CASE("Literals, defaults written out, and how axes pair up do count as they should") {
  const Digest plain = key(two_ramps("a", "b", 3, ""), "s");
  CHECK(key(two_ramps("a", "b", 4, ""), "s") != plain);
  CHECK(key(two_ramps("a", "b", 3, "a"), "s") != plain);  // paired instead of combined
  const auto constant = [](const Json& inputs) {
    return document({{"c", {{"type", "constant"}, {"inputs", inputs}}}});
  };
  CHECK(key(constant({{"value", 1}}), "c") == key(constant(Json::object()), "c"));
  CHECK(key(constant({{"value", 1}}), "c") == key(constant({{"value", 1.0}}), "c"));
  CHECK(key(constant({{"value", 2}}), "c") != key(constant({{"value", 1}}), "c"));
}

TEST_CASE("A change reaches every node behind it and no other") {
  const auto chain = [](double value) {
    return document({{"a", {{"type", "constant"}, {"inputs", {{"value", value}}}}},
                     {"b", {{"type", "count_runs"}, {"inputs", {{"value", {{"from", "a"}}}}}}},
                     {"c", {{"type", "constant"}, {"inputs", {{"value", 7}}}}}});
  };
  CHECK(key(chain(1), "b") != key(chain(2), "b"));
  CHECK(key(chain(1), "c") == key(chain(2), "c"));
}

TEST_CASE("Two equal ranges of different nodes share one result but stay different axes") {
  Cache cache(1 << 20);
  const Json graph = two_ramps("a", "b", 3, "");
  CHECK(support::numbers(toy_registry, graph, "s", cache) == std::vector<double>{0, 1, 2, 1, 2, 3, 2, 3, 4});
  CHECK(support::numbers(toy_registry, graph, "s", cache) == std::vector<double>{0, 1, 2, 1, 2, 3, 2, 3, 4});
  CHECK(cache.size() == 2);
}
