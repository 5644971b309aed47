#include "jobs/sweep_file.h"

#include <algorithm>
#include <optional>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "graph/stopped.h"
#include "service/variant_file.h"

namespace dini::jobs {
namespace {

Result<SharedComputed> evaluated(const Engine& engine, const EvaluateRequest& request, const Job& job) {
  const Result<SharedPrepared> prepared = engine.prepare(request, job.cancel);
  if (!prepared) return prepared.problems();
  if (SharedComputed known = engine.find(**prepared)) return known;
  return engine.compute(**prepared, job);
}

/// The problems of a variant, which say that they are its.
Problems of_variant(std::size_t index, Problems problems) {
  for (Problem& problem : problems) problem.detail = "variant " + std::to_string(index) + ": " + problem.detail;
  return problems;
}

}  // namespace

Result<SharedFile> sweep_file(const Engine& engine, const SweepRequest& request, const Job& job) {
  const auto at_once = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  std::vector<VariantModel> models;
  std::size_t bytes = 0;
  for (std::size_t next = request.first; next < request.variants.size();) {
    const std::size_t count = std::min(request.variants.size() - next, at_once);
    std::vector<std::optional<Result<SharedComputed>>> computed(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      computed[i] = evaluated(engine, request.with(request.variants.at(next + i)), job);
    });
    if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
    for (std::size_t i = 0; i < count; ++i, ++next) {
      if (!*computed[i]) return of_variant(next, computed[i]->problems());
      const SharedFile& model = (**computed[i])->model;
      bytes += model->bytes->size();
      models.push_back({next, request.variants.at(next), model});
    }
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
