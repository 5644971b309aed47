#include "jobs/job_request.h"

namespace dini::jobs {
namespace {

bool is_sweep(const Json& body) { return body.contains("grid") || body.contains("zip") || body.contains("list"); }

}  // namespace

Result<JobRequest> read_sweep_request(Json body, const Engine& engine) {
  auto read = read_sweep_body(std::move(body), engine);
  if (!read) return read.problems();
  auto variants = Variants::read(*read, read->parameters, engine.limits().sweep_variants);
  if (!variants) return variants.problems();
  const auto deadline = read->deadline_milliseconds;
  const auto first = static_cast<std::size_t>(read->first);
  auto outputs = std::move(read->outputs).value_or(std::vector<std::string>());
  return JobRequest{SweepRequest{*std::move(read), *std::move(variants), std::move(outputs), first}, deadline};
}

Result<JobRequest> read_job_request(Json body, const std::string& format, JobKind kind, const Engine& engine) {
  if (kind == JobKind::fit) {
    auto fit = read_fit_body(std::move(body), engine);
    if (!fit) return fit.problems();
    const auto deadline = fit->deadline_milliseconds;
    return JobRequest{FitRequest(*std::move(fit)), deadline};
  }
  if (is_sweep(body)) return read_sweep_request(std::move(body), engine);
  auto read = read_evaluate_body(std::move(body), engine);
  if (!read) return read.problems();
  read->format = format;
  const auto deadline = read->deadline_milliseconds;
  return JobRequest{EvaluateRequest(*std::move(read)), deadline};
}

}  // namespace dini::jobs
