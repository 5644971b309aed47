#include "jobs/variant_outcome.h"

#include <algorithm>
#include <tbb/parallel_pipeline.h>
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

std::size_t most_at_once() {
  return 1 + static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
}

void evaluate_in_order(const Engine& engine, const SweepRequest& request, std::size_t first, const Job& job,
                       const std::function<bool()>& go_on, const std::function<void(const VariantOutcome&)>& hand_on) {
  using Made = std::shared_ptr<const VariantOutcome>;
  const auto begin = [&](tbb::flow_control& control) {
    if (first == request.variants.size() || job.cancel.stopped() || !go_on()) {
      control.stop();
      return first;
    }
    return first++;
  };
  const auto make = [&](std::size_t index) {
    // A thread that waits for parts of this variant does not begin another one meanwhile, which would hold this one up.
    return tbb::this_task_arena::isolate(
        [&] { return std::make_shared<const VariantOutcome>(evaluate_variant(engine, request, index, job)); });
  };
  const auto tell = [&](const Made& outcome) { hand_on(*outcome); };
  tbb::parallel_pipeline(most_at_once(), tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, begin) &
                                             tbb::make_filter<std::size_t, Made>(tbb::filter_mode::parallel, make) &
                                             tbb::make_filter<Made, void>(tbb::filter_mode::serial_in_order, tell));
}

}  // namespace dini::jobs
