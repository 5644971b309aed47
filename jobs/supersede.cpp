#include "jobs/supersede.h"

#include <utility>

namespace dini::jobs {
namespace {

/// Keys whose requests have been answered are forgotten when there are so many.
constexpr std::size_t many_keys = 1024;

}  // namespace

void Supersede::take_over(const std::string& key, Clock::time_point arrived,
                          const std::shared_ptr<Flights::Interest>& interest) {
  if (key.empty()) return;
  std::shared_ptr<Flights::Interest> older = interest;
  {
    const std::lock_guard lock(mutex_);
    if (newest_.size() >= many_keys) {
      std::erase_if(newest_, [](const auto& entry) { return entry.second.interest.expired(); });
    }
    Newest& newest = newest_[key];
    if (newest.arrived <= arrived) {
      older = std::exchange(newest, {arrived, interest}).interest.lock();
    }
  }
  if (older) older->stop(StopReason::superseded);
}

}  // namespace dini::jobs
