// The hard ranges on the cards of all nodes are what the engine accepts: all of it, and nothing beyond.

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/nodes/node_inputs.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Graphs that would make more values than this are only checked: the point is what is accepted.
constexpr std::size_t most_evaluated = 3'000'000;

bool is_integer(const InputPort& port) { return port.types.front() == WireType::integer; }

Json literal_of(const InputPort& port, double value) {
  return is_integer(port) ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json beyond(const InputPort& port, double bound, double direction) {
  return is_integer(port) ? Json(static_cast<std::int64_t>(bound + direction))
                          : Json(std::nextafter(bound, direction * HUGE_VAL));
}

/// The other counts of a node at their least, so that one bound at a time decides how much there is to compute.
Json least_counts(const Subject& subject) {
  Json literals = Json::object();
  for (const InputPort& port : subject.type->inputs) {
    if (is_integer(port) && port.spec.minimum) literals[port.name] = literal_of(port, *port.spec.minimum);
  }
  return literals;
}

/// Calls `test` with every input of every node that has a hard range, and that range.
template <class Test>
void for_every_bound(Test test) {
  for (const Subject& subject : all_subjects()) {
    for (const InputPort& port : subject.type->inputs) {
      if (!port.spec.minimum) continue;
      CAPTURE(subject.name(), port.name);
      test(subject, port, *port.spec.minimum, -1.0);
      test(subject, port, *port.spec.maximum, 1.0);
    }
  }
}

}  // namespace

TEST_CASE("every node runs at every hard bound") {
  for_every_bound([](const Subject& subject, const InputPort& port, double bound, double) {
    CAPTURE(bound);
    Json literals = least_counts(subject);
    literals[port.name] = literal_of(port, bound);
    CatalogueGraph graph = graph_of(wired_nodes(subject, {.literals = literals}));
    const bool small = graph.static_problems().empty() && graph.plan().cost.samples <= most_evaluated;
    for (const Problem& problem : small ? graph.problems("subject") : graph.static_problems()) {
      FAIL_CHECK(problem.code << " at " << problem.node << "." << problem.port << ": " << problem.detail);
    }
  });
}

TEST_CASE("every node refuses a literal just outside a hard bound, and says what it takes") {
  for_every_bound([](const Subject& subject, const InputPort& port, double bound, double direction) {
    const CatalogueGraph graph =
        graph_of(wired_nodes(subject, {.literals = {{port.name, beyond(port, bound, direction)}}}));
    REQUIRE(codes(graph.static_problems()) == std::multiset<std::string>{"out-of-range subject." + port.name});
    const Problem& problem = graph.static_problems().front();
    CHECK(problem.pointer == "/graph/nodes/subject/inputs/" + port.name);
    CHECK(problem.fix[0]["value"] == literal_of(port, bound));
  });
}

TEST_CASE("every node refuses a wired number just outside a hard bound") {
  for_every_bound([](const Subject& subject, const InputPort& port, double bound, double direction) {
    if (is_integer(port)) return;
    Json nodes = wired_nodes(subject, {});
    nodes["outside"] = make("number", {{"value", beyond(port, bound, direction)}});
    nodes["subject"]["inputs"][port.name] = from("outside");
    CatalogueGraph graph = graph_of(nodes);
    CHECK(codes(graph.problems("subject")) == std::multiset<std::string>{"out-of-range subject." + port.name});
  });
}
