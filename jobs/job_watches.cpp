// Telling those who watch jobs.

#include <utility>

#include "jobs/job_runner.h"

namespace dini::jobs {
namespace {

/// How often those who watch hear of progress.
constexpr std::chrono::milliseconds tick_time{200};

}  // namespace

JobRunner::Watch::Watch(JobRunner& runner, std::string id, std::function<void()> changed)
    : runner_(runner), id_(std::move(id)), changed_(std::move(changed)) {
  const std::lock_guard lock(runner_.watching_);
  place_ = runner_.watches_.insert(runner_.watches_.end(), this);
  if (std::exchange(runner_.ticks_, true)) return;
  runner_.ticking_ = runner_.flights_.alarms().at(Clock::now() + tick_time, [&runner] { runner.tick(); });
}

JobRunner::Watch::~Watch() {
  const std::lock_guard lock(runner_.watching_);
  runner_.watches_.erase(place_);
}

void JobRunner::tell(const std::string& id) {
  const std::lock_guard lock(watching_);
  for (const Watch* watch : watches_) {
    if (watch->id_ == id) watch->changed_();
  }
}

/// Tells of progress as long as anybody watches.
void JobRunner::tick() {
  if (is_stopped()) return;
  const std::lock_guard lock(watching_);
  for (const Watch* watch : watches_) watch->changed_();
  ticks_ = !watches_.empty();
  if (ticks_) ticking_ = flights_.alarms().at(Clock::now() + tick_time, [this] { tick(); });
}

}  // namespace dini::jobs
