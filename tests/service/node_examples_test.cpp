// Every graph in examples/nodes/, of which docs/nodes.md shows one under each node.

#include <catch2/catch.hpp>
#include <set>

#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

/// More would hide the node that the example explains; solids take a few before there is something to combine.
constexpr std::size_t most_nodes = 18;

std::map<std::string, Json> node_examples() { return examples(std::string(DINI_EXAMPLES) + "/nodes"); }

std::set<std::string> types_of(const Json& graph) {
  std::set<std::string> types;
  for (const auto& [id, node] : graph["nodes"].items()) types.insert(node["type"].get<std::string>());
  return types;
}

}  // namespace

TEST_CASE("Every node has an example in examples/nodes, and every example there has its node") {
  std::set<std::string> nodes, names;
  const Json catalogue = make_engine()->catalogue();
  for (const Json& node : catalogue["nodes"]) nodes.insert(node["id"].get<std::string>());
  for (const auto& [id, graph] : node_examples()) names.insert(id);
  CHECK(names == nodes);
}

TEST_CASE("Every example of a node says what it shows, is small, and has its node and a camera") {
  for (const auto& [id, graph] : node_examples()) {
    CAPTURE(id);
    const Json& meta = graph["meta"];
    CHECK_FALSE(meta["title"].get<std::string>().empty());
    CHECK(meta["description"].get<std::string>().ends_with('.'));
    CHECK(meta["camera"]["position"].size() == 3);
    CHECK(meta["camera"]["target"].size() == 3);
    CHECK(graph["nodes"].size() <= most_nodes);
    CHECK(types_of(graph).contains(id));
    CHECK(types_of(graph).contains("export"));
  }
}

TEST_CASE("Every example of a node is drawn by all of its nodes, without warnings") {
  const std::unique_ptr<Engine> engine_owner = example_engine();
  const Engine& engine = *engine_owner;
  for (const auto& [id, graph] : node_examples()) {
    CAPTURE(id);
    const Result<Answered> answer =
        answered(engine, {.graph = graph, .parameters = Json::object(), .output = "", .quality = Quality::final});
    require_none(answer ? Problems{} : answer.problems());
    const Json report = answer->report();
    CHECK(report["warnings"] == Json::array());
    CHECK(report["model"]["triangles"] > 0);
    for (const auto& [node, entry] : graph["nodes"].items()) CHECK(report["nodes"].contains(node));
  }
}
