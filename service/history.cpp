#include "service/history.h"

#include <algorithm>

#include "graph/cost.h"

namespace dini {
namespace {

constexpr std::size_t most_graphs = 64;
/// Older measurements count half once so much newer work has come.
constexpr double speed_window = 2e10;
/// Until something was measured: a unit of work is about a nanosecond.
constexpr double usual_milliseconds_per_unit = 1e-6;

}  // namespace

std::size_t History::place_of(const Digest& fingerprint) { return DigestHash()(fingerprint) % places; }

void History::note(const Digest& graph, const Plan& plan, const Evaluation& evaluation) {
  const std::lock_guard lock(mutex_);
  for (const PlannedNode& node : plan.nodes) {
    const NodeRun* run = evaluation.run(node);
    if (run == nullptr || run->cached) continue;
    computed_[place_of(node.fingerprint)] = node.fingerprint;
    Engine::NodeTime& time = times_[node.type->id];
    ++time.runs;
    time.seconds += run->milliseconds / 1000;
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

void History::clear() {
  const std::lock_guard lock(mutex_);
  std::ranges::fill(computed_, Digest{});
  parameters_ = {};
  parameters_order_ = {};
}

std::vector<Engine::NodeTime> History::node_times() const {
  const std::lock_guard lock(mutex_);
  std::vector<Engine::NodeTime> times;
  for (const auto& [type, time] : times_) times.push_back({type, time.runs, time.seconds});
  return times;
}

bool History::was_computed(const Digest& fingerprint) const {
  const std::lock_guard lock(mutex_);
  return computed_[place_of(fingerprint)] == fingerprint;
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
