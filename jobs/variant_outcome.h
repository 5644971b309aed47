#pragma once

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

/// How many variants `evaluate_together` evaluates.
std::size_t variants_at_once();

/// Evaluates one variant, with all of its outputs.
VariantOutcome evaluate_variant(const Engine& engine, const SweepRequest& request, std::size_t index, const Job& job);

/// Evaluates variants from that one on, as many as there are threads, all at once; their outcomes in their order.
std::vector<VariantOutcome> evaluate_together(const Engine& engine, const SweepRequest& request, std::size_t first,
                                              const Job& job);

}  // namespace dini::jobs
