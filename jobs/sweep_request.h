#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jobs/alarms.h"
#include "service/engine.h"
#include "service/variants.h"

namespace dini::jobs {

/// What a sweep asks of the engine: one request for many settings of its parameters.
struct SweepRequest {
  EvaluateRequest base;
  Variants variants;
  std::vector<std::string> outputs = {};  ///< that each variant is evaluated for; empty: what `base` says
  std::size_t first = 0;                  ///< the variant to begin with
  Alarms::Clock::time_point deadline = Alarms::Clock::time_point::max();
  /// The JSON that it was read from, with its graph, for whoever is to read it again elsewhere; null where nobody is.
  SharedBytes text = nullptr;

  /// The request of the variant with these values, for one of the outputs.
  EvaluateRequest with(const Json& setting, const std::string& output) const;
  /// The outputs that a variant is evaluated for.
  std::vector<std::string> outputs_of_variant() const;
};

/// What is known of a sweep before it begins.
struct SweepCost {
  std::size_t work = 0;   ///< predicted nanoseconds of one processor, as if its variants and outputs shared nothing
  std::size_t bytes = 0;  ///< predicted memory of the largest variant, with all of its outputs
};

/// Checks every variant. Those that are wrong cost nothing and are told when it is their turn; a sweep over the limit
/// is a problem.
Result<std::shared_ptr<const SweepCost>> predict(const Engine& engine, const SweepRequest& request, const Job& job);

}  // namespace dini::jobs
