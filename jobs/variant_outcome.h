#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graph/job.h"
#include "jobs/sweep_request.h"

namespace dini::jobs {

/// How one output of a variant fared.
struct OutputOutcome {
  std::string output;  ///< as the request has it: empty for the only one
  Result<SharedPrepared> prepared;
  Result<SharedComputed> computed;  ///< the problems of preparing where there are some
};

/// How one variant fared.
struct VariantOutcome {
  std::size_t index = 0;
  Json setting;                        ///< its values by parameter
  bool lists_outputs = false;          ///< the request does
  std::vector<OutputOutcome> outputs;  ///< at least one, as they were asked for; one that failed stops no other

  bool failed() const;
  /// The problems of all outputs, each once.
  Problems problems() const;
  /// The models that were made.
  std::vector<SharedFile> files() const;
};

/// Evaluates one variant, with all of its outputs.
VariantOutcome evaluate_variant(const Engine& engine, const SweepRequest& request, std::size_t index, const Job& job);

/// How many variants `evaluate_in_order` holds at once at the most: one for each thread, and one that is done and waits
/// for an earlier one.
std::size_t most_at_once();

/// Evaluates variants from that one on, with all threads, and hands on how they fared, in their order and one at a
/// time, on any thread. No further one is begun once `go_on` says no or the job is stopped; those that were begun are
/// handed on.
void evaluate_in_order(const Engine& engine, const SweepRequest& request, std::size_t first, const Job& job,
                       const std::function<bool()>& go_on, const std::function<void(const VariantOutcome&)>& hand_on);

}  // namespace dini::jobs
