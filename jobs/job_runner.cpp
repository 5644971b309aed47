#include "jobs/job_runner.h"

#include <algorithm>

#include "jobs/live_job.h"
#include "service/problem_json.h"

namespace dini::jobs {
namespace {

/// When the store is asked again that did not write.
constexpr std::chrono::milliseconds storage_pause{1000};
/// How often old jobs are looked for, at the least.
constexpr std::chrono::milliseconds expiry_pause{60'000};

}  // namespace

JobRunner::JobRunner(const Engine& engine, Flights& flights, Sweeps& sweeps, store::JobStore jobs, const Terms& terms)
    : engine_(engine), flights_(flights), sweeps_(sweeps), jobs_(std::move(jobs)), terms_(terms) {}

void JobRunner::start() {
  if (const auto left = jobs_.unfinished()) waiting_.assign(left->begin(), left->end());
  thread_ = std::thread([this] { work(); });
}

JobRunner::~JobRunner() {
  stop();
  for (const auto& [id, live] : live_) live->sweep = nullptr;  // they hold each other
}

void JobRunner::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  const std::lock_guard lock(watching_);
  ticks_ = true;  // so that nothing sets the alarm again
  for (const Watch* watch : watches_) watch->changed_();
}

bool JobRunner::is_stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

JobRunner::Load JobRunner::load() const {
  const std::lock_guard lock(mutex_);
  return {live_.size(), waiting_.size()};
}

Result<std::optional<store::AddedJob>> JobRunner::add(const store::NewJob& job) {
  auto added = jobs_.add(job, terms_.most_waiting);
  if (!added || !*added || (*added)->outcome != store::AddedJob::Outcome::added) return added;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(job.id);
  }
  changed_.notify_all();
  return added;
}

JobStatus JobRunner::status_of(store::JobRecord record) const {
  const std::lock_guard lock(mutex_);
  JobStatus status{std::move(record), 0};
  if (status.record.state == "succeeded") status.progress = 1;
  const auto found = live_.find(status.record.id);
  if (found == live_.end()) return status;
  Live& live = *found->second;
  if (live.interest != nullptr && live.sweep == nullptr) {
    const Progress::State state = live.interest->progress();
    if (state.announced > 0) {
      const double fraction = static_cast<double>(state.done) / static_cast<double>(state.announced);
      live.progress = std::max(live.progress, std::min(fraction, 1.0));
    }
  }
  if (status.record.state == "running") {
    status.progress = live.progress;
    status.best = live.best;
    if (live.canceling) status.record.state = "canceling";
  }
  return status;
}

Result<std::optional<JobStatus>> JobRunner::find(const std::string& id) const {
  auto record = jobs_.find(id);
  if (!record) return record.problems();
  if (!*record) return std::optional<JobStatus>();
  return std::optional(status_of(**std::move(record)));
}

Result<std::optional<JobStatus>> JobRunner::cancel(const std::string& id) {
  std::shared_ptr<Flights::Interest> interest;
  std::shared_ptr<Sweep> sweep;
  bool waited = false;
  {
    const std::lock_guard lock(mutex_);
    waited = std::erase(waiting_, id) > 0;
    if (const auto found = live_.find(id); found != live_.end()) {
      found->second->canceling = true;
      interest = found->second->interest;
      sweep = found->second->sweep;
    }
  }
  if (waited) {
    const auto ended = jobs_.finish(id, "canceled", "[]", {});
    if (!ended) {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(id);
      return ended.problems();
    }
    tell(id);
  } else if (sweep != nullptr) {
    sweep->stop(StopReason::canceled);
    end(id, {.state = "canceled"});
  } else if (interest != nullptr) {
    interest->stop(StopReason::canceled);
  }
  return find(id);
}

/// Begins jobs when it is their turn, until it is told to stop.
void JobRunner::work() {
  Clock::time_point expiry = Clock::now();
  std::unique_lock lock(mutex_);
  while (!stopped_) {
    const bool late = std::ranges::any_of(live_, [](const auto& live) { return live.second->ending.has_value(); });
    if (late) {
      changed_.wait_for(lock, storage_pause, [this] { return stopped_; });
      lock.unlock();
      write_late_ends();
      lock.lock();
    } else if (!waiting_.empty() && live_.size() < terms_.at_once) {
      const std::string id = waiting_.front();
      waiting_.pop_front();
      const SharedLive live = live_[id] = std::make_shared<Live>();
      lock.unlock();
      begin(id, live);
      lock.lock();
    } else if (Clock::now() >= expiry) {
      lock.unlock();
      jobs_.expire(terms_.result_time);
      lock.lock();
      expiry = Clock::now() + std::min(expiry_pause, terms_.result_time / 4);
    } else {
      changed_.wait_until(lock, expiry);
    }
  }
}

void JobRunner::begin(const std::string& id, const SharedLive& live) {
  const auto begun = jobs_.begin(id);
  const auto record = jobs_.find(id);
  const auto body = jobs_.body(id);
  if (!begun || !record || !body || !*begun) {
    std::unique_lock lock(mutex_);
    live_.erase(id);
    if (begun && !*begun) return;  // it is there no more, or has ended
    waiting_.push_front(id);       // the store does not work just now
    changed_.wait_for(lock, storage_pause, [this] { return stopped_; });
    return;
  }
  tell(id);
  auto json = parse_json(*body, engine_.limits());
  if (!json) return end_with(id, json.problems());
  auto request = read_job_request(*std::move(json), (*record)->format, kind_of((*record)->kind), engine_);
  if (!request) return end_with(id, request.problems());
  const auto within = [&](std::chrono::milliseconds limit) -> Clock::duration {
    return std::min(limit, std::chrono::milliseconds(request->deadline_milliseconds.value_or(limit.count())));
  };
  if (request->is_fit()) {
    return fit(id, live, std::get<FitRequest>(std::move(request->asked)), within(terms_.deadline));
  }
  if (!request->is_sweep()) {
    return evaluate(id, live, std::get<EvaluateRequest>(request->asked), within(terms_.deadline));
  }
  SweepRequest asked = std::get<SweepRequest>(std::move(request->asked));
  asked.text = share(*body);
  asked.first = std::min(asked.variants.size(), asked.first + static_cast<std::size_t>((*record)->done));
  const auto limit = static_cast<std::int64_t>(engine_.limits().sweep_milliseconds);
  sweep(id, live, std::move(asked), within(std::chrono::milliseconds(limit)));
}

/// A job that did not come to its end. One that the shutdown stopped is left as it is, for the next process.
void JobRunner::end_with(const std::string& id, const Problems& problems) {
  const std::string& code = problems.front().code;
  if (code == "shutting-down") return;
  if (code == "canceled") return end(id, {.state = "canceled"});
  end(id, {.state = "failed", .errors = dump(to_json(problems))});
}

void JobRunner::end(const std::string& id, Ending ending) {
  if (write_end(id, ending)) return;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = live_.find(id); found != live_.end()) found->second->ending = std::move(ending);
  }
  changed_.notify_all();
}

bool JobRunner::write_end(const std::string& id, const Ending& ending) {
  if (!jobs_.finish(id, ending.state, ending.errors, ending.result)) return false;
  std::shared_ptr<Sweep> sweep;  // let go of without the lock; it and what is live hold each other
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = live_.find(id); found != live_.end()) {
      sweep = std::move(found->second->sweep);
      live_.erase(found);
    }
  }
  changed_.notify_all();
  tell(id);
  return true;
}

void JobRunner::write_late_ends() {
  std::map<std::string, Ending> late;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, live] : live_) {
      if (live->ending) late.emplace(id, *live->ending);
    }
  }
  for (const auto& [id, ending] : late) write_end(id, ending);
}

}  // namespace dini::jobs
