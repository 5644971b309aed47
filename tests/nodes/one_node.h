#pragma once

// Graphs that are about one node, which is called "it".

#include "tests/support/catalogue.h"

namespace dini::support {

/// A node of a type, among others that its inputs come from.
inline CatalogueGraph graph_with(const std::string& type, const Json& inputs, Json others = Json::object()) {
  others["it"] = make(type, inputs);
  return graph_of(others);
}

/// The code of what its evaluation says first, or nothing.
inline std::string problem_of(CatalogueGraph graph) {
  const Problems problems = graph.problems("it");
  return problems.empty() ? "" : problems.front().code;
}

}  // namespace dini::support
