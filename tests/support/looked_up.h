#pragma once

// What an engine finds on the wires of a graph, as plain numbers.

#include <catch2/catch.hpp>
#include <fstream>

#include "service/engine.h"

namespace dini::support {

inline const Engine& engine() {
  static const Engine one;
  return one;
}

/// The answer of `inspect`; a problem fails the test.
inline Json looked_up(const Json& graph, const std::string& node, const std::string& output = "", const Json& parameters = Json::object(),
                      bool full = false) {
  const Cancel cancel;
  const Result<Json> answer = engine().inspect({graph, parameters, node, output, full}, cancel);
  if (!answer.has_value()) FAIL(to_json(answer.error()).dump());
  return *answer;
}

/// The code of the first problem that keeps a wire from having a value, or nothing.
inline std::string problem_of(const Json& graph, const std::string& node, const Json& parameters = Json::object()) {
  const Cancel cancel;
  const Result<Json> answer = engine().inspect({graph, parameters, node, "", false}, cancel);
  return answer.has_value() ? "" : to_json(answer.error())[0]["code"].get<std::string>();
}

inline Json only_value(const Json& graph, const std::string& node, const std::string& output = "") {
  const Json answer = looked_up(graph, node, output);
  REQUIRE(answer["values"].size() == 1);
  return answer["values"][0];
}

/// A document of one node called "it", and the nodes that it refers to.
inline Json graph_of(const std::string& type, Json inputs, Json others = Json::object()) {
  others["it"] = {{"type", type}, {"inputs", std::move(inputs)}};
  return {{"format", 1}, {"nodes", std::move(others)}};
}
inline Json made(const std::string& type, Json inputs) { return {{"type", type}, {"inputs", std::move(inputs)}}; }
inline Json from(const std::string& wire) { return {{"from", wire}}; }

/// One of the example graphs; the build says where they are.
inline Json example(const std::string& name) {
  std::ifstream file(std::string(DINI_EXAMPLES) + "/" + name + ".json");
  REQUIRE(file);
  return Json::parse(file);
}

inline Vector vector_at(const Json& triple) { return {triple[0], triple[1], triple[2]}; }

inline void require_near(const Json& value, const Json& expected, double tolerance = 1e-12) {
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
