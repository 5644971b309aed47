#include "jobs/sweep.h"

#include <algorithm>
#include <atomic>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <utility>

#include "graph/stopped.h"

namespace dini::jobs {

namespace {

/// After so long others may have the place.
constexpr std::chrono::milliseconds slice_time{100};
/// How long a sweep waits that is not let in.
constexpr std::chrono::milliseconds busy_pause{50};

/// So many variants are checked before their work is added up.
constexpr std::size_t checked_together = 64;

OutputOutcome evaluated(const Engine& engine, const EvaluateRequest& request, const Job& job) {
  Result<SharedPrepared> prepared = engine.prepare(request, job.cancel);
  if (!prepared) return {request.output, prepared.problems(), prepared.problems()};
  SharedComputed known = engine.find(**prepared);
  Result<SharedComputed> computed = known != nullptr ? std::move(known) : engine.compute(**prepared, job);
  return {request.output, std::move(prepared), std::move(computed)};
}

VariantOutcome evaluated(const Engine& engine, const SweepRequest& request, std::size_t index, const Job& job) {
  VariantOutcome outcome{index, request.variants.at(index), !request.outputs.empty(), {}};
  for (const std::string& output : request.outputs_of_variant()) {
    outcome.outputs.push_back(evaluated(engine, request.with(outcome.setting, output), job));
  }
  return outcome;
}

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

/// No two sweeps have an outcome in common.
Digest new_name() {
  static std::atomic<std::uint64_t> count = 0;
  return DigestBuilder().text("sweep").integer(++count).finish();
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
        [&] { return std::make_shared<const VariantOutcome>(evaluated(engine, request, index, job)); });
  };
  const auto tell = [&](const Made& outcome) { hand_on(*outcome); };
  tbb::parallel_pipeline(most_at_once(), tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, begin) &
                                             tbb::make_filter<std::size_t, Made>(tbb::filter_mode::parallel, make) &
                                             tbb::make_filter<Made, void>(tbb::filter_mode::serial_in_order, tell));
}

Sweep::Sweep(const Engine& engine, Flights& flights, SweepRequest request, const SweepCost& cost,
             std::unique_ptr<Taker> taker)
    : engine_(engine),
      flights_(flights),
      request_(std::move(request)),
      cost_(cost),
      name_(new_name()),
      taker_(std::move(taker)),
      next_(request_.first) {}

void Sweep::stop(StopReason reason) {
  std::shared_ptr<Flights::Interest> interest;
  Alarms::Alarm again;  // taken back without the lock, which it may be waiting for
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
    again = std::move(again_);
    interest = std::move(interest_);
  }
  if (interest) interest->stop(reason);
}

/// Asks for a place for the next slice.
void Sweep::go_on() {
  const std::lock_guard lock(mutex_);
  if (over_) return;
  const std::shared_ptr<Sweep> self = shared_from_this();
  const std::size_t left = request_.variants.size() - next_;
  interest_ = flights_.ask<bool>(
      {.key = name_,
       .bytes = cost_.bytes * std::min(left, most_at_once()),
       .work = static_cast<std::size_t>(std::chrono::nanoseconds(slice_time).count()),
       .deadline = request_.deadline},
      [self](const Job& job) { return self->run_slice(job); },
      [self](const Result<std::shared_ptr<const bool>>& outcome, Flights::Begun) { self->slice_told(outcome); });
  if (interest_ != nullptr) return;
  again_ = flights_.alarms().at(Clock::now() + busy_pause, [self] { self->go_on(); });
}

Result<std::shared_ptr<const bool>> Sweep::run_slice(const Job& job) {
  const Clock::time_point until = Clock::now() + slice_time;
  std::atomic<bool> goes_on = true;
  bool has_begun = false;  // each slice gets on, however late it is given its place
  evaluate_in_order(
      engine_, request_, next_, job,
      [&] { return goes_on && (!std::exchange(has_begun, true) || Clock::now() < until); },
      [&](const VariantOutcome& outcome) {
        const std::lock_guard lock(taking_);  // who stops this work does not wait for it
        if (job.cancel.stopped() || ended_ || !wanted_) return;
        wanted_ = taker_->take(outcome);
        ++next_;
        goes_on = wanted_ && taker_->has_room(nullptr);
      });
  if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
  return std::make_shared<const bool>(true);
}

void Sweep::slice_told(const Result<std::shared_ptr<const bool>>& outcome) {
  {
    const std::lock_guard lock(mutex_);
    interest_ = nullptr;
    if (over_) return;
  }
  if (!outcome) return end(outcome.problems());
  if (next_ == request_.variants.size() || !wanted_) return end({});
  // A taker that has no room holds this until there is.
  if (taker_->has_room([self = shared_from_this()] { self->go_on(); })) go_on();
}

void Sweep::end(const Problems& reasons) {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  const std::lock_guard lock(taking_);
  ended_ = true;
  taker_->end(reasons, next_);
}

}  // namespace dini::jobs
