#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "graph/check.h"
#include "graph/evaluate.h"
#include "graph/parameters.h"
#include "tests/support/documents.h"

namespace dini::support {

inline CheckReport checked(const Registry& registry, const Json& json, const Json& parameters = Json::object(),
                           const Limits& limits = {}) {
  const Result<Document> read = read_document(json, limits, registry);
  REQUIRE(read.has_value());
  const auto values = resolve_parameters(*read, parameters);
  REQUIRE(values.has_value());
  return check(registry, *read, *values, Quality::final, limits);
}

/// The codes of all problems, as "code node.port".
inline std::multiset<std::string> codes(const Problems& problems) {
  std::multiset<std::string> all;
  for (const Problem& problem : problems) {
    all.insert(problem.code + " " + problem.node + (problem.port.empty() ? "" : "." + problem.port));
  }
  return all;
}

/// The numbers on an output of a graph that must evaluate.
inline std::vector<double> numbers(const Registry& registry, const Json& json, const std::string& node, Cache& cache) {
  const CheckReport report = checked(registry, json);
  INFO(codes(report.problems).size());
  for (const Problem& problem : report.problems) FAIL(problem.code << ": " << problem.detail);
  const std::size_t index = report.plan.index.at(node);
  const Result<Evaluation> evaluation = evaluate(report.plan, {index}, cache, Job());
  REQUIRE(evaluation.has_value());
  const Value value = evaluation->value(report.plan, index, 0);
  const Column<double>& column = column_of<double>(value);
  return {column.component(0), column.component(0) + column.size()};
}

inline std::vector<double> numbers(const Registry& registry, const Json& json, const std::string& node) {
  Cache cache(1 << 20);
  return numbers(registry, json, node, cache);
}

}  // namespace dini::support
