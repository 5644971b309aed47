#include "graph/evaluate.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <tbb/task_group.h>

#include "graph/cost.h"
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

/// Walks from the targets to what they need. `visit` is given the index of each node, of one that many need more than
/// once, and says whether to go on to what that needs.
template <class Visit>
void walk_needed(const Plan& plan, const std::vector<std::size_t>& targets, Visit visit) {
  std::vector<std::size_t> stack = targets;
  while (!stack.empty()) {
    const std::size_t index = standing_at(plan, stack.back());
    stack.pop_back();
    if (!visit(index)) continue;
    const std::vector<std::size_t> sources = source_nodes(plan.nodes[index]);
    stack.insert(stack.end(), sources.begin(), sources.end());
  }
}

class Evaluator {
 public:
  Evaluator(const Plan& plan, Cache& cache, const Cancel& cancel, const Progress& progress)
      : plan_(plan), cache_(cache), cancel_(cancel), progress_(progress) {}

  /// What the targets need, as far as cached results.
  void find_needed(const std::vector<std::size_t>& targets) {
    walk_needed(plan_, targets, [this](std::size_t index) {
      const PlannedNode& planned = plan_.nodes[index];
      const auto [place, first] = steps_.try_emplace(planned.fingerprint);
      if (!first) return false;
      Step& step = place->second;
      step.node = &planned;
      if (auto result = cache_.find<NodeResult>(planned.fingerprint)) {
        step.run = {0, true, std::move(result)};
        return false;
      }
      to_run_.push_back(&step);
      return true;
    });
  }

  bool nothing_to_run() const { return to_run_.empty(); }

  Result<Evaluation> run() {
    connect();
    for (const Step* step : to_run_) progress_.announce(cost_of(*step->node).work);
    // Found before any is started: jobs that become ready later are started by the last step they waited for.
    std::vector<Step*> first;
    std::copy_if(to_run_.begin(), to_run_.end(), std::back_inserter(first),
                 [](const Step* step) { return step->waiting_for == 0; });
    for (Step* step : first) start(*step);
    tasks_.wait();
    if (cancel_.stopped()) return stopped_problem(cancel_.reason());
    return collect();
  }

  Result<Evaluation> collect() {
    Problems problems;
    Evaluation evaluation;
    bool memory_ran_out = memory_ran_out_;
    for (auto& [fingerprint, step] : steps_) {
      problems.insert(problems.end(), step.problems.begin(), step.problems.end());
      memory_ran_out = memory_ran_out || step.fate == Fate::memory_ran_out;
      if (step.fate == Fate::exception) {
        problems.push_back({"internal", "something went wrong inside this node", step.node->id});
      }
      if (step.run.result) evaluation.runs.emplace(fingerprint, std::move(step.run));
    }
    if (memory_ran_out) return out_of_memory();
    if (!problems.empty()) return problems;
    return evaluation;
  }

 private:
  /// How the function of a node ended. Kept as a word, since telling more would need memory.
  enum class Fate { not_run, well, failed, memory_ran_out, exception };

  struct Step {
    const PlannedNode* node = nullptr;
    std::atomic<std::size_t> waiting_for = 0;
    std::vector<Step*> followers;
    NodeRun run;
    Problems problems;
    Fate fate = Fate::not_run;
    std::atomic<bool> spoiled = false;
  };

  Step& step_at(std::size_t node) { return steps_.at(plan_.nodes[node].fingerprint); }

  void connect() {
    for (Step* step : to_run_) {
      for (const std::size_t source : source_nodes(*step->node)) {
        Step& before = step_at(source);
        if (before.run.cached) continue;
        before.followers.push_back(step);
        ++step->waiting_for;
      }
    }
  }

  /// An exception that left a task would cancel all others in the middle of their loops. So none does: what cannot even
  /// be started for want of memory is remembered, and everything behind it stays without a result.
  void start(Step& step) noexcept {
    try {
      tasks_.run([this, &step] { run_step(step); });
    } catch (...) {
      memory_ran_out_ = true;
    }
  }

  void run_step(Step& step) noexcept {
    if (!step.spoiled && !cancel_.stopped()) compute(step);
    progress_.add(cost_of(*step.node).work);
    for (Step* next : step.followers) {
      if (!step.run.result) next->spoiled = true;
      if (--next->waiting_for == 0) start(*next);
    }
  }

  void compute(Step& step) noexcept {
    try {
      step.fate = Fate::failed;
      run_node_of(step);
    } catch (const std::bad_alloc&) {
      step.fate = Fate::memory_ran_out;
    } catch (...) {
      step.fate = Fate::exception;
    }
  }

  void run_node_of(Step& step) {
    const auto begin = std::chrono::steady_clock::now();
    const PlannedNode& node = *step.node;
    const Context context(cancel_, plan_.detail.quality, node.triangle_budget, node.file.get());
    const auto column = [this](const Source& source) -> const AnyColumn& {
      return step_at(source.node).run.result->columns[source.output];
    };
    Result<std::vector<AnyColumn>> columns = run_node(node, column, context);
    if (cancel_.stopped() || tbb::is_current_task_group_canceling()) return;
    if (!columns) {
      step.problems = columns.problems();
      return;
    }
    auto result = std::make_shared<NodeResult>();
    result->columns = *std::move(columns);
    gather_warnings(node, context.take_warnings(), *result);
    const std::size_t size = bytes(*result);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    cache_.insert<NodeResult>(node.fingerprint, result, size, place_of(node));
    step.run = {took.count(), false, std::move(result)};
    step.fate = Fate::well;
  }

  /// What the results of one node are versions of, whatever its inputs.
  static Digest place_of(const PlannedNode& node) {
    return DigestBuilder().text("place").text(node.type->id).text(node.id).finish();
  }

  void gather_warnings(const PlannedNode& node, std::vector<Warning> own, NodeResult& result) {
    std::map<Digest, std::shared_ptr<const NodeWarnings>> said;
    for (const std::size_t source : source_nodes(node)) {
      for (const auto& before : step_at(source).run.result->warnings) said.emplace(before->fingerprint, before);
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
  std::map<Digest, Step> steps_;
  std::vector<Step*> to_run_;
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
  const Source& source = std::get<Source>(planned.bypass->from);
  return {planned.outputs.front().axes, column(source.node, source.output)};
}

Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache, const Job& job) {
  return evaluate(plan, targets, cache, job.cancel, job.progress);
}

Result<Evaluation> evaluate(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache,
                            const Cancel& cancel, const Progress& progress) {
  Evaluator evaluator(plan, cache, cancel, progress);
  evaluator.find_needed(targets);
  return evaluator.run();
}

std::optional<Evaluation> find_evaluation(const Plan& plan, const std::vector<std::size_t>& targets, Cache& cache) {
  const Job job;
  Evaluator evaluator(plan, cache, job.cancel, job.progress);
  evaluator.find_needed(targets);
  if (!evaluator.nothing_to_run()) return std::nullopt;
  Result<Evaluation> evaluation = evaluator.collect();
  return evaluation ? std::optional(*std::move(evaluation)) : std::nullopt;
}

Foreseen foresee(const Plan& plan, const std::vector<std::size_t>& targets, const Cache& cache) {
  Foreseen foreseen;
  std::set<Digest> seen;
  walk_needed(plan, targets, [&](std::size_t index) {
    const Digest& fingerprint = plan.nodes[index].fingerprint;
    if (!seen.insert(fingerprint).second) return false;
    const bool known = cache.contains(fingerprint);
    (known ? foreseen.known : foreseen.running).push_back(index);
    return !known;
  });
  std::ranges::sort(foreseen.running);
  std::ranges::sort(foreseen.known);
  return foreseen;
}

}  // namespace dini
