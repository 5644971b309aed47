#pragma once

#include <functional>

#include "graph/job.h"
#include "service/requests/fit_request.h"

namespace dini::fitting {

/// Until when a fit goes on, and who is told of it.
struct FitTerms {
  /// When it ends with the best so far, after the evaluation that runs then; a job that is stopped for its deadline
  /// ends it within an evaluation.
  Cancel::Clock::time_point deadline = Cancel::Clock::time_point::max();
  /// Given the best so far whenever there is a better one: {"parameters": ..., "objective": ...}. May be empty.
  std::function<void(const Json& best)> improved = {};
};

/// What can be told of a request without evaluating: the memory that it takes, or the same problems, but for those that
/// the values have.
Result<std::size_t> check(const Engine& engine, const FitRequest& request, const Cancel& cancel);

/// Finds values of the varied parameters: from the given place and the best of others, spread evenly over the bounds,
/// downhill by NLopt and, where there are only squares to sum, by least squares to the end. The same request gives the
/// same answer. Progress counts evaluations. The answer has the schema `Fit`; problems are those of the request, of the
/// graph at the first place, and of `stopped_problem`.
Result<Json> fit(const Engine& engine, const FitRequest& request, const Job& job, const FitTerms& terms = {});

/// A document whose parameters have these defaults.
Json with_defaults(Json document, const Json& parameters);

}  // namespace dini::fitting
