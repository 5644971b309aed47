#pragma once

// The example graphs, and what the engine finds on their wires.

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "tests/support/example_engine.h"

namespace dini::support {

/// One of the example graphs; the build says where they are.
inline Json example(const std::string& name) {
  std::ifstream file(std::string(DINI_EXAMPLES) + "/" + name + ".json");
  REQUIRE(file);
  return Json::parse(file);
}

/// What `inspect` answers for "node" or "node.output"; a problem fails the test.
inline Json looked_up(const Json& graph, const std::string& place, const Json& parameters = Json::object(),
                      bool full = false) {
  static const std::unique_ptr<Engine> engine = example_engine();
  const std::size_t dot = place.find('.');
  const std::string output = dot == std::string::npos ? "" : place.substr(dot + 1);
  const Result<SharedBytes> answer =
      engine->inspect({engine->read(graph), parameters, place.substr(0, dot), output, full}, Job());
  if (!answer) FAIL(to_json(answer.problems()).dump());
  return Json::parse(**answer);
}

/// Numbers, triples and lists of them, to a tolerance relative to the expected size, at least one.
inline void require_near(const Json& value, const Json& expected, double tolerance) {
  INFO("got " << value.dump() << ", expected " << expected.dump());
  if (expected.is_array()) {
    REQUIRE(value.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) require_near(value[i], expected[i], tolerance);
    return;
  }
  REQUIRE(value.is_number());
  const double wanted = expected.get<double>();
  REQUIRE(std::abs(value.get<double>() - wanted) <= tolerance * std::max(1.0, std::abs(wanted)));
}

}  // namespace dini::support
