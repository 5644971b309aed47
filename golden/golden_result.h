#pragma once

#include <map>
#include <string>

#include "golden/model_facts.h"
#include "graph/problem.h"

namespace dini {

/// What a graph gave once, to compare later results with.
struct GoldenResult {
  std::string engine;                         ///< version of the engine
  std::string graph;                          ///< hash of the graph
  Json parameters = Json::object();           ///< values that were given
  std::map<std::string, ModelFacts> outputs;  ///< by the node that exports
};

/// As the text of a file: JSON with a line for each sample, lengths with seven digits at least.
std::string write_golden(const GoldenResult& result);

/// Problems: `not-json`, and `bad-golden` for what is no golden result or one of another format.
Result<GoldenResult> read_golden(const std::string& text);

}  // namespace dini
