// The parameters of examples are found again from their meshes.

#include <catch2/catch.hpp>

#include "fitting/fit.h"
#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

struct Example {
  std::string name;
  std::string mesh;
  Json truth;
};

const Engine& examples_engine() {
  static const std::unique_ptr<Engine> made = example_engine();
  return *made;
}

/// The example, of fewer curves and corners, so that the test is quick.
Json graph_of(const Example& example) {
  constexpr int most = 40;
  Json graph = examples().at(example.name);
  for (Json& node : graph["nodes"]) {
    for (const auto& [name, value] : node["inputs"].items()) {
      const bool is_count = name.starts_with("count") || name.starts_with("segments");
      if (is_count && value.is_number() && value > most) value = most;
    }
  }
  return graph;
}

/// The mesh of the example with the true parameters, as a file of another program would bring it: in single precision.
std::string mesh_file(const Example& example) {
  Json graph = graph_of(example);
  graph["nodes"]["out"]["inputs"]["model"] = from(example.mesh);
  const auto answer = answered(examples_engine(), {.graph = graph, .parameters = example.truth, .format = "ply"});
  require_none(answer ? Problems() : answer.problems());
  const auto added = examples_engine().add_asset(*answer->computed->model->bytes, "", Cancel());
  require_none(added ? Problems() : added.problems());
  return added->sha256;
}

Json fitted(const Example& example) {
  FitRequest request{
      .graph = examples_engine().read(graph_of(example)), .target_mesh = mesh_file(example), .mesh = example.mesh};
  for (const auto& [name, value] : example.truth.items()) request.vary[name] = Json::array();
  const Result<Json> found = fitting::fit(examples_engine(), request, Job());
  require_none(found ? Problems() : found.problems());
  return *found;
}

void check_recovered(const Example& example) {
  const Json found = fitted(example);
  CAPTURE(example.name, found.dump(1));
  CHECK(found["outcome"] == "converged");
  CHECK(found["undetermined"].empty());
  for (const auto& [name, value] : example.truth.items()) {
    CAPTURE(name);
    CHECK(std::abs(found["parameters"][name].get<double>() - value.get<double>()) < 1e-3);
  }
}

}  // namespace

TEST_CASE("Reach and height of the boosted ring are found from its mesh") {
  check_recovered({"fig04_boosted_ring", "skin", {{"reach", 1.37}, {"height", 0.9}}});
}

TEST_CASE("Reach and radius of the boosted circle are found from its mesh") {
  check_recovered({"fig02_boosted_circle", "skin", {{"reach", 0.63}, {"radius", 0.71}}});
}

TEST_CASE("Turns, pitch and reach of the twisted ring are found from its mesh") {
  check_recovered({"fig05_twisted_ring", "skin", {{"turns", 1.9}, {"pitch", 0.8}, {"reach", 1.25}}});
}

TEST_CASE("Strength, power and softening of the warped sphere are found from its mesh") {
  check_recovered({"fig12_warped_sphere", "warped", {{"strength", 0.45}, {"power", 3.1}, {"softening", 0.8}}});
}

TEST_CASE("Bends, turn and reach of the cyclidic patch are found from its mesh") {
  check_recovered({"cyclidic_patch", "skin", {{"bend_u", -0.4}, {"bend_v", -0.65}, {"turn", 1.1}, {"reach", 1.9}}});
}
