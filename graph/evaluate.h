#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "graph/cache.h"
#include "graph/job.h"
#include "graph/node_result.h"
#include "graph/plan.h"
#include "graph/problem.h"

namespace dini {

/// How a node fared in an evaluation.
struct NodeRun {
  double milliseconds = 0;
  bool cached = false;
  std::shared_ptr<const NodeResult> result;
};

/// What was computed or found, by fingerprint: plans that compute the same under other ids can share one evaluation.
/// Nodes behind a cached one were not needed and are absent.
struct Evaluation {
  std::map<Digest, NodeRun> runs;

  /// How a node of a plan fared; null for one that was not needed, or that is bypassed.
  const NodeRun* run(const PlannedNode& node) const;

  /// A value by its place. The node must be among the targets of the evaluation or have been run for it.
  Value value(const Plan& plan, std::size_t node, std::size_t output) const;
};

/// Computes what `targets` need, each fingerprint once, independent nodes in parallel, results taken from and put into
/// the cache. Fails with all problems found: a failed node spoils those behind it and lets the others finish, whether
/// it failed by its own word, by an exception (`internal`) or for want of memory (`out-of-memory`). When the job stops
/// the work, the only problem is that of `stopped_problem`. Nothing but complete results enters the cache. The
/// predicted work of every node that has to run is announced before the first one runs, and is done when the node is.
Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache, const Job& job);

/// The same for work that is a part of a job whose progress is told by another.
Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache,
                            const Cancel& cancel, const Progress& progress);

/// What `evaluate` would do: nodes by index into the plan, each thing that is computed once.
struct Foreseen {
  std::vector<std::size_t> running;  ///< in the order of the plan
  std::vector<std::size_t> known;    ///< whose results are in the cache; what only they need does not run
};
Foreseen foresee(const Plan& plan, const std::vector<std::size_t>& targets, const Cache& cache);

/// What `evaluate` would answer if nothing had to be computed; nothing when something has to be.
std::optional<Evaluation> find_evaluation(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache);

}  // namespace dini
