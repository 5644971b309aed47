#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "jobs/sweep_request.h"
#include "service/requests/requests.h"

namespace dini::jobs {

/// What a job is asked to do: one evaluation, or a sweep.
struct JobRequest {
  std::variant<EvaluateRequest, SweepRequest> asked;
  std::optional<std::int64_t> deadline_milliseconds = {};  ///< counted from when the job begins

  bool is_sweep() const { return std::holds_alternative<SweepRequest>(asked); }
  /// "evaluate" or "sweep".
  std::string kind() const { return is_sweep() ? "sweep" : "evaluate"; }
  /// Variants of a sweep, else 0.
  std::size_t total() const { return is_sweep() ? std::get<SweepRequest>(asked).variants.size() : 0; }
};

/// Reads the body of a sweep.
Result<JobRequest> read_sweep_request(Json body, const Engine& engine);

/// Reads the body of an evaluation or, when it has a grid, a zip or a list, of a sweep. `format` is that of the models
/// of an evaluation.
Result<JobRequest> read_job_request(Json body, const std::string& format, const Engine& engine);

}  // namespace dini::jobs
