#pragma once

#include "cli/run_options.h"
#include "cli/testing/case_result.h"
#include "cli/testing/cases.h"
#include "cli/testing/find_graphs.h"
#include "cli/testing/golden_files.h"

namespace dini::cli {

/// A graph that was read with its cases, or what keeps it from being tested.
struct TestGraph {
  FoundGraph found;
  std::optional<SourceText> source = {};
  std::optional<Json> document = {};
  std::vector<TestCase> cases = {};
  CaseResult failure = {};  ///< when there is no document or no case

  bool can_run() const { return document && !cases.empty(); }
};

/// Reads a graph and the file of cases beside it; without one there is a case of the defaults.
TestGraph read_test_graph(const FoundGraph& found, const Limits& limits);

/// Evaluates all outputs of a graph, or only its checks when it has none, and compares them with their golden results.
/// Each output has the deadline of `running`. Nothing is thrown.
CaseResult run_case(const Engine& engine, const TestGraph& graph, const TestCase& asked, const GoldenOptions& golden,
                    const RunOptions& running);

}  // namespace dini::cli
