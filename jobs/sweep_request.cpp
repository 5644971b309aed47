#include "jobs/sweep_request.h"

#include <algorithm>

#include "graph/stopped.h"
#include "jobs/compute_queue.h"

namespace dini::jobs {

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
  for (std::size_t index = request.first; index < request.variants.size(); ++index) {
    const Json setting = request.variants.at(index);
    std::size_t bytes = 0;
    for (const std::string& output : request.outputs_of_variant()) {
      const Result<SharedPrepared> prepared = engine.prepare(request.with(setting, output), job.cancel);
      if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
      if (!prepared) continue;
      if ((*prepared)->work != ComputeQueue::unknown_work) cost.work += (*prepared)->work;
      bytes += (*prepared)->bytes;
    }
    cost.bytes = std::max(cost.bytes, bytes);
    if (cost.work <= engine.limits().sweep_work) continue;
    constexpr std::size_t units_per_second = 1'000'000'000;
    return Problem{.code = "limit-exceeded",
                   .detail = "up to variant " + std::to_string(index) + " the sweep would compute for about " +
                             std::to_string(cost.work / units_per_second) + " seconds of one processor, at most " +
                             std::to_string(engine.limits().sweep_work / units_per_second) + " are accepted",
                   .in_request = true};
  }
  return std::make_shared<const SweepCost>(cost);
}

}  // namespace dini::jobs
