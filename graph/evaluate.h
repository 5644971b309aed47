#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "graph/cache.h"
#include "graph/plan.h"
#include "graph/problem.h"

namespace dini {

/// How a node fared in an evaluation.
struct NodeRun {
  double milliseconds = 0;
  bool cached = false;
  std::shared_ptr<const NodeResult> result;
};

/// The runs of all nodes that were needed, by index into the plan. Nodes behind a cached one were not needed and are
/// absent.
struct Evaluation {
  std::map<std::size_t, NodeRun> runs;

  /// A value by its place. The node must be among the targets of the evaluation or have been run for it.
  Value value(const Plan& plan, std::size_t node, std::size_t output) const;
};

/// What is said about work that was stopped.
Problem stopped_problem(StopReason reason);

/// Called after every node with how many of the needed nodes are done; from any thread.
using Progress = std::function<void(std::size_t done, std::size_t needed)>;

/// Computes what `targets` need, each node once, independent nodes in parallel, results taken from and put into the
/// cache. Fails with all problems found: a failed node spoils those behind it and lets the others finish. When `cancel`
/// stops the work, the only problem has the code of the reason: `deadline`, `superseded`, `client-gone` or
/// `shutting-down`.
Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache,
                            const Cancel& cancel, const Progress& progress = {});

}  // namespace dini
