#pragma once

// Measures: the values of chosen outputs, told beside a model or instead of it.

#include <optional>
#include <string>
#include <vector>

#include "graph/evaluate.h"
#include "graph/limits.h"
#include "graph/registry.h"
#include "service/prepared.h"

namespace dini {

/// Which outputs are measured, before anything is planned.
struct MeasureName {
  std::string place;  ///< as it was asked for: "node" or "node.output"
  std::string node;
  std::size_t output = 0;
};

/// Reads "node" (its first output) and "node.output"; repeats do not count. Problems: `unknown-node` and `unknown-port`
/// with the pointer of the entry, `limit-exceeded` for too many of them.
Result<std::vector<MeasureName>> read_measures(const Registry& registry, const Document& document,
                                               const std::vector<std::string>& asked, const Limits& limits);

/// The same in a plan that has their nodes. A measure of too many values is a problem.
Result<std::vector<Measure>> plan_measures(const Plan& plan, const std::vector<MeasureName>& names,
                                           const Limits& limits);

/// By place: the value of an output without axes, else the list of its values, the last axis fastest.
Json measures_of(const PreparedGraph& prepared, const Evaluation& evaluation);

}  // namespace dini
