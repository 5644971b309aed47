#include "graph/evaluate.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <tbb/task_group.h>

#include "graph/run_node.h"

namespace dini {

namespace {

/// The nodes that one node's inputs come from.
std::vector<std::size_t> source_nodes(const PlannedNode& node) {
  std::vector<std::size_t> sources;
  for (const PlannedInput& input : node.inputs) {
    for (const PlannedItem& item : input.items) {
      const auto* source = std::get_if<Source>(&item.from);
      if (source != nullptr && std::find(sources.begin(), sources.end(), source->node) == sources.end()) {
        sources.push_back(source->node);
      }
    }
  }
  return sources;
}

class Evaluator {
 public:
  Evaluator(const Plan& plan, Cache& cache, const Cancel& cancel, const Progress& progress)
      : plan_(plan), cache_(cache), cancel_(cancel), progress_(progress) {}

  Result<Evaluation> run(const std::vector<std::size_t>& targets) {
    find_needed(targets);
    // Found before any is started: jobs that become ready later are started by the last job they waited for.
    std::vector<std::size_t> first;
    std::copy_if(to_run_.begin(), to_run_.end(), std::back_inserter(first),
                 [this](std::size_t node) { return jobs_.at(node).waiting_for == 0; });
    for (const std::size_t node : first) start(node);
    tasks_.wait();
    if (cancel_.stopped()) return stopped_problem(cancel_.reason());
    return collect();
  }

 private:
  struct Job {
    std::atomic<std::size_t> waiting_for = 0;
    std::vector<std::size_t> followers;
    NodeRun run;
    Problems problems;
    std::atomic<bool> spoiled = false;
  };

  /// Walks from the targets to what they need and stops at cached results.
  void find_needed(std::vector<std::size_t> stack) {
    while (!stack.empty()) {
      const std::size_t node = stack.back();
      stack.pop_back();
      if (plan_.nodes[node].bypass) {
        push_bypassed(node, stack);
        continue;
      }
      if (jobs_.contains(node)) continue;
      Job& job = jobs_[node];
      if (auto result = cache_.find(plan_.nodes[node].fingerprint)) {
        job.run = {0, true, std::move(result)};
        continue;
      }
      to_run_.push_back(node);
      const std::vector<std::size_t> sources = source_nodes(plan_.nodes[node]);
      stack.insert(stack.end(), sources.begin(), sources.end());
    }
    for (const std::size_t node : to_run_) {
      for (const std::size_t source : source_nodes(plan_.nodes[node])) {
        if (jobs_.at(source).run.cached) continue;
        jobs_.at(source).followers.push_back(node);
        ++jobs_.at(node).waiting_for;
      }
    }
  }

  void push_bypassed(std::size_t node, std::vector<std::size_t>& stack) const {
    if (const auto* source = std::get_if<Source>(&plan_.nodes[node].bypass->from)) stack.push_back(source->node);
  }

  void start(std::size_t node) {
    tasks_.run([this, node] { run_job(node); });
  }

  void run_job(std::size_t node) {
    Job& job = jobs_.at(node);
    if (!job.spoiled && !cancel_.stopped()) compute(plan_.nodes[node], job);
    if (progress_) progress_(++done_, to_run_.size());
    for (const std::size_t follower : job.followers) {
      Job& next = jobs_.at(follower);
      if (!job.run.result) next.spoiled = true;
      if (--next.waiting_for == 0) start(follower);
    }
  }

  void compute(const PlannedNode& node, Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    const Context context(cancel_, plan_.detail.quality, node.triangle_budget);
    const auto column = [this](const Source& source) -> const AnyColumn& {
      return jobs_.at(source.node).run.result->columns[source.output];
    };
    Result<NodeResult> result = run_node(node, column, context);
    if (cancel_.stopped()) return;
    if (!result) {
      job.problems = result.problems();
      return;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    job.run = {took.count(), false, std::make_shared<const NodeResult>(std::move(*result))};
    cache_.insert(node.fingerprint, job.run.result);
  }

  Result<Evaluation> collect() {
    Problems problems;
    Evaluation evaluation;
    for (auto& [node, job] : jobs_) {
      problems.insert(problems.end(), job.problems.begin(), job.problems.end());
      if (job.run.result) evaluation.runs.emplace(node, std::move(job.run));
    }
    if (!problems.empty()) return problems;
    return evaluation;
  }

  const Plan& plan_;
  Cache& cache_;
  const Cancel& cancel_;
  const Progress& progress_;
  std::map<std::size_t, Job> jobs_;
  std::vector<std::size_t> to_run_;
  std::atomic<std::size_t> done_ = 0;
  tbb::task_group tasks_;
};

}  // namespace

Problem stopped_problem(StopReason reason) {
  switch (reason) {
    case StopReason::superseded:
      return {"superseded", "a newer request took this one's place"};
    case StopReason::client_gone:
      return {"client-gone", "the client went away"};
    case StopReason::shutting_down:
      return {"shutting-down", "the server is shutting down"};
    case StopReason::none:
    case StopReason::deadline:
      break;
  }
  return {"deadline", "the evaluation did not finish before its deadline"};
}

Value Evaluation::value(const Plan& plan, std::size_t node, std::size_t output) const {
  const PlannedNode& planned = plan.nodes[node];
  if (!planned.bypass) return {planned.outputs[output].axes, runs.at(node).result->columns[output]};
  if (const auto* source = std::get_if<Source>(&planned.bypass->from)) {
    return {planned.outputs.front().axes, runs.at(source->node).result->columns[source->output]};
  }
  return std::get<Value>(std::get<Argument>(planned.bypass->from));
}

Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache,
                            const Cancel& cancel, const Progress& progress) {
  return Evaluator(plan, cache, cancel, progress).run(targets);
}

}  // namespace dini
