#include "service/history.h"

#include "graph/cost.h"

namespace dini {
namespace {

constexpr std::size_t most_computed = 100'000;
constexpr std::size_t most_graphs = 1'000;
/// Older measurements count half once so much newer work has come.
constexpr double speed_window = 2e10;
/// Until something was measured: a unit of work is about a nanosecond.
constexpr double usual_milliseconds_per_unit = 1e-6;

}  // namespace

void History::note(const Digest& graph, const Plan& plan, const Evaluation& evaluation) {
  const std::lock_guard lock(mutex_);
  for (const PlannedNode& node : plan.nodes) {
    const NodeRun* run = evaluation.run(node);
    if (run == nullptr || run->cached) continue;
    note_computed(node.fingerprint);
    const double work = cost_of(node).work;
    for (Speed* speed : {&speeds_[node.type->id], &all_}) {
      if (speed->work > speed_window) *speed = {speed->milliseconds / 2, speed->work / 2};
      speed->milliseconds += run->milliseconds;
      speed->work += work;
    }
  }
  if (parameters_.insert_or_assign(graph, plan.parameters).second) parameters_order_.push_back(graph);
  while (parameters_order_.size() > most_graphs) {
    parameters_.erase(parameters_order_.front());
    parameters_order_.pop_front();
  }
}

void History::note_computed(const Digest& fingerprint) {
  if (!computed_.insert(fingerprint).second) return;
  computed_order_.push_back(fingerprint);
  while (computed_order_.size() > most_computed) {
    computed_.erase(computed_order_.front());
    computed_order_.pop_front();
  }
}

bool History::was_computed(const Digest& fingerprint) const {
  const std::lock_guard lock(mutex_);
  return computed_.contains(fingerprint);
}

std::optional<ParameterValues> History::last_parameters(const Digest& graph) const {
  const std::lock_guard lock(mutex_);
  const auto found = parameters_.find(graph);
  return found != parameters_.end() ? std::optional(found->second) : std::nullopt;
}

double History::milliseconds_per_unit(const std::string& type) const {
  const std::lock_guard lock(mutex_);
  const auto found = speeds_.find(type);
  const Speed& speed = found != speeds_.end() && found->second.work > 0 ? found->second : all_;
  return speed.work > 0 ? speed.milliseconds / speed.work : usual_milliseconds_per_unit;
}

}  // namespace dini
