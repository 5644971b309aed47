#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "jobs/sweep_request.h"
#include "service/requests/fit_request.h"
#include "service/requests/requests.h"

namespace dini::jobs {

/// What a job is asked to do: one evaluation, a sweep, or a fit.
struct JobRequest {
  std::variant<EvaluateRequest, SweepRequest, FitRequest> asked;
  std::optional<std::int64_t> deadline_milliseconds = {};  ///< counted from when the job begins

  bool is_sweep() const { return std::holds_alternative<SweepRequest>(asked); }
  bool is_fit() const { return std::holds_alternative<FitRequest>(asked); }
  /// "evaluate", "sweep" or "fit".
  std::string kind() const { return is_sweep() ? "sweep" : is_fit() ? "fit" : "evaluate"; }
  /// Variants of a sweep, else 0.
  std::size_t total() const { return is_sweep() ? std::get<SweepRequest>(asked).variants.size() : 0; }
};

/// Which bodies there are: those of fits come to an address of their own.
enum class JobKind { evaluate_or_sweep, fit };

/// The kind of a job that is kept, by what `JobRequest::kind` said of it.
inline JobKind kind_of(std::string_view kept) { return kept == "fit" ? JobKind::fit : JobKind::evaluate_or_sweep; }

/// Reads the body of a sweep.
Result<JobRequest> read_sweep_request(Json body, const Engine& engine);

/// Reads the body of a fit, or of an evaluation or, when it has a grid, a zip or a list, of a sweep. `format` is that
/// of the models of an evaluation.
Result<JobRequest> read_job_request(Json body, const std::string& format, JobKind kind, const Engine& engine);

}  // namespace dini::jobs
