#include "jobs/sweep_file.h"

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
  std::size_t bytes = 0;
  for (std::size_t next = request.first; next < request.variants.size();) {
    const std::vector<VariantOutcome> outcomes = evaluate_together(engine, request, next, job);
    if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
    for (const VariantOutcome& outcome : outcomes) {
      if (outcome.failed()) return of_variant(outcome);
      VariantModel variant{outcome.index, outcome.setting, {}};
      for (const OutputOutcome& output : outcome.outputs) {
        const SharedFile& model = (*output.computed)->model;
        bytes += model->bytes->size();
        variant.models.push_back({outcome.lists_outputs ? output.output : "", model});
      }
      models.push_back(std::move(variant));
    }
    next += outcomes.size();
    // All are held twice when they are put together.
    if (bytes > engine.limits().request_bytes / 2) {
      return Problem{.code = "limit-exceeded",
                     .detail = "the models of the first " + std::to_string(next) + " variants are " +
                               std::to_string(bytes) + " bytes together, at most " +
                               std::to_string(engine.limits().request_bytes / 2) + " are put into one file",
                     .in_request = true};
    }
  }
  return variant_file(models, *request.base.graph, request.base.parameters);
}

}  // namespace dini::jobs
