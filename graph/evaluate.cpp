#include "graph/evaluate.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <tbb/task_group.h>

#include "graph/run_node.h"
#include "graph/stopped.h"

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

/// The node that stands at a place once bypassed nodes have passed their inputs on; nothing where a literal does.
std::optional<std::size_t> standing_at(const Plan& plan, std::size_t node) {
  while (plan.nodes[node].bypass) {
    const auto* source = std::get_if<Source>(&plan.nodes[node].bypass->from);
    if (source == nullptr) return std::nullopt;
    node = source->node;
  }
  return node;
}

class Evaluator {
 public:
  Evaluator(const Plan& plan, Cache& cache, const Cancel& cancel, const Progress& progress)
      : plan_(plan), cache_(cache), cancel_(cancel), progress_(progress) {}

  /// Walks from the targets to what they need and stops at cached results.
  void find_needed(const std::vector<std::size_t>& targets) {
    std::vector<std::size_t> stack = targets;
    while (!stack.empty()) {
      const std::optional<std::size_t> node = standing_at(plan_, stack.back());
      stack.pop_back();
      if (!node) continue;
      const PlannedNode& planned = plan_.nodes[*node];
      const auto [place, first] = jobs_.try_emplace(planned.fingerprint);
      if (!first) continue;
      Job& job = place->second;
      job.node = &planned;
      if (auto result = cache_.find<NodeResult>(planned.fingerprint)) {
        job.run = {0, true, std::move(result)};
        continue;
      }
      to_run_.push_back(&job);
      const std::vector<std::size_t> sources = source_nodes(planned);
      stack.insert(stack.end(), sources.begin(), sources.end());
    }
  }

  bool nothing_to_run() const { return to_run_.empty(); }

  Result<Evaluation> run() {
    connect();
    // Found before any is started: jobs that become ready later are started by the last job they waited for.
    std::vector<Job*> first;
    std::copy_if(to_run_.begin(), to_run_.end(), std::back_inserter(first),
                 [](const Job* job) { return job->waiting_for == 0; });
    for (Job* job : first) start(*job);
    tasks_.wait();
    if (cancel_.stopped()) return stopped_problem(cancel_.reason());
    return collect();
  }

  Result<Evaluation> collect() {
    Problems problems;
    Evaluation evaluation;
    bool memory_ran_out = memory_ran_out_;
    for (auto& [fingerprint, job] : jobs_) {
      problems.insert(problems.end(), job.problems.begin(), job.problems.end());
      memory_ran_out = memory_ran_out || job.fate == Fate::memory_ran_out;
      if (job.fate == Fate::exception) {
        problems.push_back({"internal", "something went wrong inside this node", job.node->id});
      }
      if (job.run.result) evaluation.runs.emplace(fingerprint, std::move(job.run));
    }
    if (memory_ran_out) return out_of_memory();
    if (!problems.empty()) return problems;
    return evaluation;
  }

 private:
  /// How the function of a node ended. Kept as a word, since telling more would need memory.
  enum class Fate { not_run, well, failed, memory_ran_out, exception };

  struct Job {
    const PlannedNode* node = nullptr;
    std::atomic<std::size_t> waiting_for = 0;
    std::vector<Job*> followers;
    NodeRun run;
    Problems problems;
    Fate fate = Fate::not_run;
    std::atomic<bool> spoiled = false;
  };

  Job& job_at(std::size_t node) { return jobs_.at(plan_.nodes[node].fingerprint); }

  void connect() {
    for (Job* job : to_run_) {
      for (const std::size_t source : source_nodes(*job->node)) {
        Job& before = job_at(source);
        if (before.run.cached) continue;
        before.followers.push_back(job);
        ++job->waiting_for;
      }
    }
  }

  /// An exception that left a task would cancel all others in the middle of their loops. So none does: what cannot even
  /// be started for want of memory is remembered, and everything behind it stays without a result.
  void start(Job& job) noexcept {
    try {
      tasks_.run([this, &job] { run_job(job); });
    } catch (...) {
      memory_ran_out_ = true;
    }
  }

  void run_job(Job& job) noexcept {
    if (!job.spoiled && !cancel_.stopped()) compute(job);
    if (progress_) progress_(++done_, to_run_.size());
    for (Job* next : job.followers) {
      if (!job.run.result) next->spoiled = true;
      if (--next->waiting_for == 0) start(*next);
    }
  }

  void compute(Job& job) noexcept {
    try {
      job.fate = Fate::failed;
      run_node_of(job);
    } catch (const std::bad_alloc&) {
      job.fate = Fate::memory_ran_out;
    } catch (...) {
      job.fate = Fate::exception;
    }
  }

  void run_node_of(Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    const PlannedNode& node = *job.node;
    const Context context(cancel_, plan_.detail.quality, node.triangle_budget, node.file.get());
    const auto column = [this](const Source& source) -> const AnyColumn& {
      return job_at(source.node).run.result->columns[source.output];
    };
    Result<std::vector<AnyColumn>> columns = run_node(node, column, context);
    if (cancel_.stopped() || tbb::is_current_task_group_canceling()) return;
    if (!columns) {
      job.problems = columns.problems();
      return;
    }
    auto result = std::make_shared<NodeResult>();
    result->columns = *std::move(columns);
    gather_warnings(node, context.take_warnings(), *result);
    const std::size_t size = bytes(*result);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    cache_.insert<NodeResult>(node.fingerprint, result, size);
    job.run = {took.count(), false, std::move(result)};
    job.fate = Fate::well;
  }

  void gather_warnings(const PlannedNode& node, std::vector<Warning> own, NodeResult& result) {
    std::map<Digest, std::shared_ptr<const NodeWarnings>> said;
    for (const std::size_t source : source_nodes(node)) {
      for (const auto& before : job_at(source).run.result->warnings) said.emplace(before->fingerprint, before);
    }
    if (!own.empty()) {
      said[node.fingerprint] = std::make_shared<NodeWarnings>(NodeWarnings{node.fingerprint, std::move(own)});
    }
    for (auto& [fingerprint, warnings] : said) result.warnings.push_back(std::move(warnings));
  }

  const Plan& plan_;
  Cache& cache_;
  const Cancel& cancel_;
  const Progress& progress_;
  std::map<Digest, Job> jobs_;
  std::vector<Job*> to_run_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> memory_ran_out_ = false;
  tbb::task_group tasks_;
};

}  // namespace

const NodeRun* Evaluation::run(const PlannedNode& node) const {
  const auto found = node.bypass ? runs.end() : runs.find(node.fingerprint);
  return found == runs.end() ? nullptr : &found->second;
}

Value Evaluation::value(const Plan& plan, std::size_t node, std::size_t output) const {
  const PlannedNode& planned = plan.nodes[node];
  const auto column = [&](std::size_t place, std::size_t port) {
    return runs.at(plan.nodes[place].fingerprint).result->columns[port];
  };
  if (!planned.bypass) return {planned.outputs[output].axes, column(node, output)};
  if (const auto* source = std::get_if<Source>(&planned.bypass->from)) {
    return {planned.outputs.front().axes, column(source->node, source->output)};
  }
  return std::get<Value>(std::get<Argument>(planned.bypass->from));
}

Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache,
                            const Cancel& cancel, const Progress& progress) {
  Evaluator evaluator(plan, cache, cancel, progress);
  evaluator.find_needed(targets);
  return evaluator.run();
}

std::optional<Evaluation> find_evaluation(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache) {
  const Cancel cancel;
  const Progress progress;
  Evaluator evaluator(plan, cache, cancel, progress);
  evaluator.find_needed(targets);
  if (!evaluator.nothing_to_run()) return std::nullopt;
  Result<Evaluation> evaluation = evaluator.collect();
  return evaluation ? std::optional(*std::move(evaluation)) : std::nullopt;
}

}  // namespace dini
