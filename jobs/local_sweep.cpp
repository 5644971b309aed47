#include "jobs/local_sweep.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "graph/stopped.h"
#include "jobs/sweep_line.h"
#include "jobs/variant_outcome.h"

namespace dini::jobs {

namespace {

/// After so long others may have the place.
constexpr std::chrono::milliseconds slice_time{100};
/// How long a sweep waits that is not let in.
constexpr std::chrono::milliseconds busy_pause{50};

/// No two sweeps have an outcome in common.
Digest new_name() {
  static std::atomic<std::uint64_t> count = 0;
  return DigestBuilder().text("sweep").integer(++count).finish();
}

}  // namespace

LocalSweep::LocalSweep(const Engine& engine, Flights& flights, SweepRequest request, const SweepCost& cost,
                       std::unique_ptr<LineTaker> taker, std::string base_path)
    : engine_(engine),
      flights_(flights),
      request_(std::move(request)),
      cost_(cost),
      name_(new_name()),
      base_path_(std::move(base_path)),
      taker_(std::move(taker)),
      next_(request_.first) {}

void LocalSweep::stop(StopReason reason) {
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
void LocalSweep::go_on() {
  const std::lock_guard lock(mutex_);
  if (over_) return;
  const std::shared_ptr<LocalSweep> self = shared_from_this();
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

Result<std::shared_ptr<const bool>> LocalSweep::run_slice(const Job& job) {
  const Clock::time_point until = Clock::now() + slice_time;
  std::atomic<bool> goes_on = true;
  bool has_begun = false;  // each slice gets on, however late it is given its place
  evaluate_in_order(
      engine_, request_, next_, job,
      [&] { return goes_on && (!std::exchange(has_begun, true) || Clock::now() < until); },
      [&](const VariantOutcome& outcome) {
        const std::lock_guard lock(taking_);  // who stops this work does not wait for it
        if (job.cancel.stopped() || ended_ || !wanted_) return;
        wanted_ = taker_->take(sweep_line(engine_, outcome, base_path_));
        ++next_;
        goes_on = wanted_ && taker_->has_room(nullptr);
      });
  if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
  return std::make_shared<const bool>(true);
}

void LocalSweep::slice_told(const Result<std::shared_ptr<const bool>>& outcome) {
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

void LocalSweep::end(const Problems& reasons) {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  const std::lock_guard lock(taking_);
  ended_ = true;
  taker_->end(reasons, next_);
}

}  // namespace dini::jobs
