#include <catch2/catch.hpp>

#include "tests/graph/toy_registry.h"
#include "tests/support/graphs.h"

using namespace dini;
using support::document;
using support::from;
using support::toy_registry;

namespace {

Json ramp(int count, const char* axis = "", bool closed = false) {
  return {{"type", "ramp"}, {"inputs", {{"count", count}, {"axis", axis}, {"closed", closed}}}};
}

Json sum(Json a, Json b) { return {{"type", "sum"}, {"inputs", {{"a", std::move(a)}, {"b", std::move(b)}}}}; }

}  // namespace

TEST_CASE("One value is a family over no axes") {
  const Json graph = document({{"s", sum(1, 2)}});
  CHECK(support::numbers(toy_registry, graph, "s") == std::vector<double>{3});
  CHECK(support::checked(toy_registry, graph).plan.nodes[0].outputs[0].axes.empty());
}

TEST_CASE("An input without an axis is constant along it") {
  CHECK(support::numbers(toy_registry, document({{"r", ramp(3)}, {"s", sum(from("r"), 10)}}), "s") ==
        std::vector<double>{10, 11, 12});
}

TEST_CASE("Different axes make all combinations, in order of first appearance") {
  const Json graph = document({{"r", ramp(2)}, {"t", ramp(3)}, {"s", sum(from("r"), from("t"))}});
  CHECK(support::numbers(toy_registry, graph, "s") == std::vector<double>{0, 1, 2, 1, 2, 3});
  const Axes axes = support::checked(toy_registry, graph).plan.nodes[2].outputs[0].axes;
  CHECK(axes == Axes{{"r", 2, false}, {"t", 3, false}});
}

TEST_CASE("Equal axis names pair up, whatever their order") {
  const Json graph = document({{"r", ramp(2)},
                               {"t", ramp(3)},
                               {"rt", sum(from("r"), from("t"))},
                               {"tr", sum(from("t"), from("r"))},
                               {"s", sum(from("rt"), from("tr"))}});
  CHECK(support::numbers(toy_registry, graph, "s") == std::vector<double>{0, 2, 4, 2, 4, 6});
}

TEST_CASE("An axis of the same name with another size or closure is an error that names both ports") {
  const auto problem = [&](const Json& second) {
    const CheckReport report = support::checked(
        toy_registry, document({{"r", ramp(2, "k")}, {"t", second}, {"s", sum(from("r"), from("t"))}}));
    REQUIRE(report.problems.size() == 1);
    return report.problems[0];
  };
  const Problem size = problem(ramp(3, "k"));
  CHECK(size.code == "axis-mismatch");
  CHECK(size.node == "s");
  CHECK(size.detail.find("axis k is 3 open at b but 2 open at a") != std::string::npos);
  CHECK(size.pointer == "/nodes/s/inputs/b");
  const Problem closure = problem(ramp(2, "k", true));
  CHECK(closure.detail.find("axis k is 2 closed at b but 2 open at a") != std::string::npos);
}

TEST_CASE("A list makes an axis called after its node, or as it says") {
  const Json items = {{"items", {5, {{"from", "r"}}, 7}}};
  const Json graph = document({{"r", ramp(2)}, {"l", {{"type", "list"}, {"inputs", items}}}});
  CHECK(support::numbers(toy_registry, graph, "l") == std::vector<double>{5, 0, 7, 5, 1, 7});
  const CheckReport report = support::checked(toy_registry, graph);
  CHECK(report.plan.nodes[report.plan.index.at("l")].outputs[0].axes == Axes{{"r", 2, false}, {"l", 3, false}});
}

TEST_CASE("Lists of one node share their axis and pair up") {
  const Json graph =
      document({{"t", {{"type", "total"}, {"inputs", {{"values", {1, 2, 3}}, {"weights", {1, 10, 100}}}}}}});
  CHECK(support::numbers(toy_registry, graph, "t") == std::vector<double>{321});
  const Json uneven = document({{"t", {{"type", "total"}, {"inputs", {{"values", {1, 2, 3}}, {"weights", {1, 10}}}}}}});
  CHECK(support::codes(support::checked(toy_registry, uneven).problems) ==
        std::multiset<std::string>{"axis-mismatch t.weights"});
}

TEST_CASE("Weights in a list pair up with the axis of a wired family") {
  const Json graph = document(
      {{"r", ramp(3)}, {"t", {{"type", "total"}, {"inputs", {{"values", from("r")}, {"weights", {1, 10, 100}}}}}}});
  CHECK(support::numbers(toy_registry, graph, "t") == std::vector<double>{210});
}

TEST_CASE("A consumed axis is the last one, or the one that is named") {
  const auto total = [&](Json inputs) {
    inputs["values"] = from("s");
    const Json node = {{"type", "total"}, {"inputs", inputs}};
    return support::numbers(
        toy_registry, document({{"r", ramp(2)}, {"t", ramp(3)}, {"s", sum(from("r"), from("t"))}, {"x", node}}), "x");
  };
  CHECK(total(Json::object()) == std::vector<double>{3, 6});
  CHECK(total({{"over", "r"}}) == std::vector<double>{1, 3, 5});
}

TEST_CASE("Consuming an axis that is not there is an error that lists those that are") {
  const auto problem = [&](Json inputs) {
    const CheckReport report = support::checked(
        toy_registry, document({{"r", ramp(2)}, {"x", {{"type", "total"}, {"inputs", std::move(inputs)}}}}));
    REQUIRE(report.problems.size() == 1);
    return report.problems[0].detail;
  };
  CHECK(problem({{"values", from("r")}, {"over", "q"}}).find("it has the axis r") != std::string::npos);
}

TEST_CASE("One value where several may stand is a list of one") {
  const auto total = [&](Json inputs) {
    const Json node = {{"type", "total"}, {"inputs", std::move(inputs)}};
    return support::numbers(toy_registry,
                            document({{"one", {{"type", "constant"}, {"inputs", {{"value", 4}}}}}, {"x", node}}), "x");
  };
  CHECK(total({{"values", 4}, {"weights", 3}}) == std::vector<double>{12});
  CHECK(total({{"values", from("one")}, {"weights", {3}}}) == std::vector<double>{12});
}

TEST_CASE("Batched functions see the same values as single ones") {
  const Json graph =
      document({{"r", ramp(5000)},
                {"t", ramp(3)},
                {"rt", sum(from("t"), from("r"))},
                {"d", {{"type", "doubled"}, {"inputs", {{"value", from("rt")}, {"offset", from("t")}}}}}});
  const std::vector<double> values = support::numbers(toy_registry, graph, "d");
  REQUIRE(values.size() == 15000);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = static_cast<double>(i / 5000);
    REQUIRE(values[i] == 2 * (t + static_cast<double>(i % 5000)) + t);
  }
}

TEST_CASE("A batched parameter may run along an inner axis") {
  const Json graph =
      document({{"r", ramp(3)},
                {"t", ramp(2)},
                {"rt", sum(from("r"), from("t"))},
                {"d", {{"type", "doubled"}, {"inputs", {{"value", from("rt")}, {"offset", from("t")}}}}}});
  CHECK(support::numbers(toy_registry, graph, "d") == std::vector<double>{0, 3, 2, 5, 4, 7});
}
