#include "jobs/sweep_request.h"

#include <algorithm>
#include <tbb/parallel_for.h>

#include "graph/stopped.h"
#include "jobs/compute_queue.h"

namespace dini::jobs {
namespace {

/// So many variants are checked before their work is added up.
constexpr std::size_t checked_together = 64;

/// Nothing for a variant that is wrong.
SweepCost cost_of_variant(const Engine& engine, const SweepRequest& request, std::size_t index, const Job& job) {
  SweepCost cost;
  const Json setting = request.variants.at(index);
  for (const std::string& output : request.outputs_of_variant()) {
    const Result<SharedPrepared> prepared = engine.prepare(request.with(setting, output), job.cancel);
    if (!prepared) continue;
    if ((*prepared)->work != ComputeQueue::unknown_work) cost.work += (*prepared)->work;
    cost.bytes += (*prepared)->bytes;
  }
  return cost;
}

}  // namespace

EvaluateRequest SweepRequest::with(const Json& setting, const std::string& output) const {
  EvaluateRequest request = base;
  request.parameters.update(setting);
  request.output = output;
  return request;
}

std::vector<std::string> SweepRequest::outputs_of_variant() const {
  return outputs.empty() ? std::vector{base.output} : outputs;
}

Result<std::shared_ptr<const SweepCost>> predict(const Engine& engine, const SweepRequest& request, const Job& job) {
  SweepCost cost;
  const std::size_t size = request.variants.size();
  for (std::size_t first = request.first; first < size; first += checked_together) {
    std::vector<SweepCost> costs(std::min(checked_together, size - first));
    tbb::parallel_for(std::size_t{0}, costs.size(),
                      [&](std::size_t i) { costs[i] = cost_of_variant(engine, request, first + i, job); });
    if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
    for (std::size_t i = 0; i < costs.size(); ++i) {
      cost.work += costs[i].work;
      cost.bytes = std::max(cost.bytes, costs[i].bytes);
      if (cost.work <= engine.limits().sweep_work) continue;
      constexpr std::size_t units_per_second = 1'000'000'000;
      return Problem{.code = "limit-exceeded",
                     .detail = "up to variant " + std::to_string(first + i) + " the sweep would compute for about " +
                               std::to_string(cost.work / units_per_second) + " seconds of one processor, at most " +
                               std::to_string(engine.limits().sweep_work / units_per_second) + " are accepted",
                     .in_request = true};
    }
  }
  return std::make_shared<const SweepCost>(cost);
}

}  // namespace dini::jobs
