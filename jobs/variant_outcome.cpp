#include "jobs/variant_outcome.h"

#include <algorithm>
#include <optional>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace dini::jobs {
namespace {

OutputOutcome evaluated(const Engine& engine, const EvaluateRequest& request, const Job& job) {
  Result<SharedPrepared> prepared = engine.prepare(request, job.cancel);
  if (!prepared) return {request.output, prepared.problems(), prepared.problems()};
  SharedComputed known = engine.find(**prepared);
  Result<SharedComputed> computed = known != nullptr ? std::move(known) : engine.compute(**prepared, job);
  return {request.output, std::move(prepared), std::move(computed)};
}

}  // namespace

std::size_t variants_at_once() {
  return static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
}

VariantOutcome evaluate_variant(const Engine& engine, const SweepRequest& request, std::size_t index, const Job& job) {
  VariantOutcome outcome{index, request.variants.at(index), !request.outputs.empty(), {}};
  for (const std::string& output : request.outputs_of_variant()) {
    outcome.outputs.push_back(evaluated(engine, request.with(outcome.setting, output), job));
  }
  return outcome;
}

bool VariantOutcome::failed() const {
  return std::ranges::any_of(outputs, [](const OutputOutcome& output) { return !output.computed; });
}

Problems VariantOutcome::problems() const {
  Problems all;
  std::vector<Json> told;
  for (const OutputOutcome& output : outputs) {
    if (output.computed) continue;
    for (const Problem& problem : output.computed.problems()) {
      Json words = to_json({problem});
      if (std::ranges::find(told, words) != told.end()) continue;
      told.push_back(std::move(words));
      all.push_back(problem);
    }
  }
  return all;
}

std::vector<SharedFile> VariantOutcome::files() const {
  std::vector<SharedFile> files;
  for (const OutputOutcome& output : outputs) {
    if (output.computed && (*output.computed)->model != nullptr) files.push_back((*output.computed)->model);
  }
  return files;
}

std::vector<VariantOutcome> evaluate_together(const Engine& engine, const SweepRequest& request, std::size_t first,
                                              const Job& job) {
  std::vector<std::optional<VariantOutcome>> outcomes(std::min(request.variants.size() - first, variants_at_once()));
  tbb::parallel_for(std::size_t{0}, outcomes.size(),
                    [&](std::size_t i) { outcomes[i] = evaluate_variant(engine, request, first + i, job); });
  std::vector<VariantOutcome> all;
  for (std::optional<VariantOutcome>& outcome : outcomes) all.push_back(*std::move(outcome));
  return all;
}

}  // namespace dini::jobs
