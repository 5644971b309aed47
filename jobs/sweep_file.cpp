#include "jobs/sweep_file.h"

#include <atomic>

#include "graph/stopped.h"
#include "jobs/variant_outcome.h"
#include "service/variant_file.h"

namespace dini::jobs {
namespace {

/// The problems of a variant, which say that they are its.
Problems of_variant(const VariantOutcome& outcome) {
  Problems problems = outcome.problems();
  for (Problem& problem : problems) problem.detail = "variant " + std::to_string(outcome.index) + ": " + problem.detail;
  return problems;
}

}  // namespace

Result<SharedFile> sweep_file(const Engine& engine, const SweepRequest& request, const Job& job) {
  std::vector<VariantModel> models;
  Problems problems;
  std::atomic<bool> goes_on = true;
  // All are held twice when they are put together.
  const std::size_t most_bytes = engine.limits().request_bytes / 2;
  std::size_t bytes = 0;
  const auto add = [&](const VariantOutcome& outcome) -> Problems {
    if (outcome.failed()) return of_variant(outcome);
    VariantModel variant{outcome.index, outcome.setting, {}};
    for (const OutputOutcome& output : outcome.outputs) {
      const SharedFile& model = (*output.computed)->model;
      bytes += model->bytes->size();
      variant.models.push_back({outcome.lists_outputs ? output.output : "", model});
    }
    models.push_back(std::move(variant));
    if (bytes <= most_bytes) return {};
    return {{.code = "limit-exceeded",
             .detail = "the models of the first " + std::to_string(outcome.index + 1) + " variants are " +
                       std::to_string(bytes) + " bytes together, at most " + std::to_string(most_bytes) +
                       " are put into one file",
             .in_request = true}};
  };
  evaluate_in_order(
      engine, request, request.first, job, [&] { return goes_on.load(); },
      [&](const VariantOutcome& outcome) {
        if (!goes_on) return;
        problems = add(outcome);
        goes_on = problems.empty();
      });
  if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
  if (!problems.empty()) return problems;
  return variant_file(models, *request.base.graph, request.base.parameters);
}

}  // namespace dini::jobs
