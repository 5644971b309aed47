// How a runner does each kind of job.

#include <algorithm>

#include "fitting/fit.h"
#include "jobs/live_job.h"

namespace dini::jobs {
namespace {

/// When work is asked for again that was not let in.
constexpr std::chrono::milliseconds busy_pause{50};

/// Lines are written together: as many as come in this time, or are so large.
constexpr std::chrono::milliseconds line_time{200};
constexpr std::size_t line_bytes = std::size_t{8} << 20;

double progress_of(std::size_t done, std::size_t total) {
  return total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total);
}

}  // namespace

/// Keeps the lines of a sweep.
class JobRunner::SweepTaker final : public LineTaker {
 public:
  SweepTaker(JobRunner& runner, std::string id, SharedLive live, std::size_t first, std::size_t total)
      : runner_(runner), id_(std::move(id)), live_(std::move(live)), told_(first), total_(total) {}

  bool take(store::JobLine line) override {
    bytes_ += line.text.size();
    for (const SharedFile& file : line.files) bytes_ += file->bytes->size();
    lines_.push_back(std::move(line));
    ++told_;
    if (bytes_ < line_bytes && Clock::now() < written_ + line_time) return true;
    return write();
  }

  bool has_room(std::function<void()>) override { return true; }

  void end(const Problems& reasons, std::size_t) override {
    write();
    if (!failure_.empty()) return runner_.end_with(id_, failure_);
    if (!reasons.empty()) return runner_.end_with(id_, reasons);
    runner_.end(id_, {.state = "succeeded"});
  }

 private:
  /// False when it cannot be: then there is no use in going on.
  bool write() {
    if (!lines_.empty()) {
      const auto written = runner_.jobs_.add_lines(id_, lines_);
      if (!written) failure_ = written.problems();
    }
    lines_.clear();
    bytes_ = 0;
    written_ = Clock::now();
    {
      const std::lock_guard lock(runner_.mutex_);
      live_->progress = progress_of(told_, total_);
    }
    return failure_.empty();
  }

  JobRunner& runner_;
  const std::string id_;
  const SharedLive live_;
  std::size_t told_;
  const std::size_t total_;
  std::vector<store::JobLine> lines_;
  std::size_t bytes_ = 0;
  Clock::time_point written_ = Clock::now();
  Problems failure_;
};

/// Asks for a place until there is one; `ask` gives null when there is none.
template <class Ask>
void JobRunner::ask_until_admitted(const std::string& id, const SharedLive& live, Ask ask) {
  std::unique_lock lock(mutex_);
  while (!stopped_ && !live->canceling) {
    lock.unlock();
    const std::shared_ptr<Flights::Interest> interest = ask();
    lock.lock();
    if (interest != nullptr) {
      live->interest = interest;
      break;
    }
    changed_.wait_for(lock, busy_pause, [this] { return stopped_; });
  }
  if (!live->canceling) return;
  // Who canceled it came before there was anything to stop.
  const auto interest = live->interest;
  lock.unlock();
  if (interest != nullptr) return interest->stop(StopReason::canceled);
  end(id, {.state = "canceled"});
}

void JobRunner::evaluate(const std::string& id, const SharedLive& live, const EvaluateRequest& request,
                         Clock::duration limit) {
  const Clock::time_point deadline = Clock::now() + limit;
  const auto prepared = engine_.prepare(request, Cancel(deadline));
  if (!prepared) return end_with(id, prepared.problems());
  const auto computed = [this, id, prepared = *prepared](const Result<SharedComputed>& outcome, Flights::Begun) {
    if (!outcome) return end_with(id, outcome.problems());
    const Computed& made = **outcome;
    end(id, {.state = "succeeded",
             .result = {dump(engine_.report(*prepared, made)), made.model ? made.model : made.preview}});
  };
  ask_until_admitted(id, live, [&, prepared = *prepared] {
    return flights_.ask<Computed>(
        {.key = prepared->content, .bytes = prepared->bytes, .work = prepared->work, .deadline = deadline},
        [this, prepared](const Job& job) -> Result<SharedComputed> {
          if (SharedComputed known = engine_.find(*prepared)) return known;
          return engine_.compute(*prepared, job);
        },
        computed);
  });
}

/// A fit ends by itself at its deadline, with the best so far.
void JobRunner::fit(const std::string& id, const SharedLive& live, FitRequest asked, Clock::duration limit) {
  const Clock::time_point deadline = Clock::now() + limit;
  const auto request = std::make_shared<const FitRequest>(std::move(asked));
  const auto bytes = fitting::check(engine_, *request, Cancel(deadline));
  if (!bytes) return end_with(id, bytes.problems());
  const auto improved = [this, weak = std::weak_ptr(live)](const Json& best) {
    const std::lock_guard lock(mutex_);
    if (const auto running = weak.lock()) running->best = best;
  };
  const auto computed = [this, id](const Result<std::shared_ptr<const Json>>& found, Flights::Begun) {
    if (!found) return end_with(id, found.problems());
    end(id, {.state = "succeeded", .result = {dump(**found), nullptr}});
  };
  ask_until_admitted(id, live, [&] {
    return flights_.ask<Json>(
        {.key = DigestBuilder().text("fit").text(id).finish(), .bytes = *bytes},
        [this, request, deadline, improved](const Job& job) -> Result<std::shared_ptr<const Json>> {
          // Within an evaluation, too, however long it would take.
          const auto alarm = flights_.alarms().at(deadline, [&job] { job.cancel.stop(StopReason::deadline); });
          auto found = fitting::fit(engine_, *request, job, {.deadline = deadline, .improved = improved});
          if (!found) return found.problems();
          return std::make_shared<const Json>(*std::move(found));
        },
        computed);
  });
}

void JobRunner::sweep(const std::string& id, const SharedLive& live, SweepRequest request, Clock::duration limit) {
  request.deadline = Clock::now() + limit;
  const auto shared = std::make_shared<const SweepRequest>(std::move(request));
  const auto predicted = [this, id, live, shared](const Result<std::shared_ptr<const SweepCost>>& cost,
                                                  Flights::Begun) {
    if (!cost) return end_with(id, cost.problems());
    auto taker = std::make_unique<SweepTaker>(*this, id, live, shared->first, shared->variants.size());
    const auto made = sweeps_.make(*shared, **cost, std::move(taker), Sweeps::Waiting::job);
    if (!made) return end_with(id, made.problems());
    const std::shared_ptr<Sweep>& sweep = *made;
    bool canceled = false;
    {
      const std::lock_guard lock(mutex_);
      canceled = live->canceling;
      if (!canceled) live->sweep = sweep;
      live->progress = progress_of(shared->first, shared->variants.size());
    }
    if (canceled) return end(id, {.state = "canceled"});
    sweep->start();
  };
  ask_until_admitted(id, live, [&] {
    return flights_.ask<SweepCost>(
        {.key = DigestBuilder().text("job").text(id).finish(), .deadline = shared->deadline},
        [this, shared](const Job& job) { return predict(engine_, *shared, job); }, predicted);
  });
}

}  // namespace dini::jobs
