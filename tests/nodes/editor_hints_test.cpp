#include "nodes/editor_hints.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "graph/card.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

Json hinted(const std::string& id) {
  Json described = card(*catalogue().find(id));
  add_editor_hints(described);
  return described;
}

bool has_port(const Json& ports, const Json& name) {
  return std::any_of(ports.begin(), ports.end(), [&](const Json& port) { return port["name"] == name; });
}

}  // namespace

TEST_CASE("What a new node begins with is accepted and is not the default") {
  std::size_t beginnings = 0;
  for (const auto& [id, type] : catalogue().types()) {
    const Json described = hinted(id);
    for (const Json& input : described["inputs"]) {
      if (!input.contains("begin")) continue;
      CAPTURE(id, input["name"]);
      ++beginnings;
      CHECK(input["begin"] != input["default"]);
      if (input.contains("min")) CHECK(input["begin"] >= input["min"]);
      if (input.contains("max")) CHECK(input["begin"] <= input["max"]);
    }
  }
  CHECK(beginnings > 0);
}

TEST_CASE("Hints name inputs and outputs that the card has, and palettes that can be chosen") {
  std::size_t legends = 0;
  for (const auto& [id, type] : catalogue().types()) {
    const Json described = hinted(id);
    if (!described.contains("legend")) continue;
    CAPTURE(id);
    ++legends;
    const Json& legend = described["legend"];
    for (const char* const name : {"palette", "range", "kind"}) {
      if (legend.contains(name)) CHECK(has_port(described["inputs"], legend[name]));
    }
    for (const Json& name : legend.value("ends", Json::array())) CHECK(has_port(described["inputs"], name));
    for (const Json& name : legend.value("found", Json::array())) CHECK(has_port(described["outputs"], name));
    for (const Json& input : described["inputs"]) {
      if (input["name"] != legend["palette"]) continue;
      for (const Json& choice : input["choices"]) CHECK(legend["colors"].contains(choice.get<std::string>()));
    }
  }
  CHECK(legends > 0);
}

TEST_CASE("A new warp leaves a ball about its pair within a few times its size") {
  const Json described = hinted("warp");
  const auto softening = std::find_if(described["inputs"].begin(), described["inputs"].end(),
                                      [](const Json& input) { return input["name"] == "softening"; });
  const auto extent_with = [](double value) {
    const Json nodes = {
        {"pair", make("point_pair", Json::object())},
        {"ball", make("sphere_mesh", {{"radius", 0.95}})},
        {"warped", make("warp", {{"shape", from("ball")}, {"generators", from("pair")}, {"softening", value}})},
        {"size", make("measure", {{"model", from("warped")}})}};
    return graph_of(nodes).one<double>("size.diagonal");
  };
  CHECK(extent_with((*softening)["begin"].get<double>()) < 10);
  CHECK(extent_with(0) > 4 * extent_with((*softening)["begin"].get<double>()));
}
