#include "jobs/supersede.h"

#include <algorithm>

namespace dini::jobs {
namespace {

/// Keys whose requests have been answered are forgotten when there are so many.
constexpr std::size_t many_keys = 1024;

template <class Asked>
bool is_answered(const Asked& asked) {
  return std::ranges::all_of(asked.interests, [](const auto& interest) { return interest.expired(); });
}

}  // namespace

void Supersede::take_over(const std::string& key, Clock::time_point arrived,
                          const std::shared_ptr<Flights::Interest>& interest, Superseding how) {
  if (key.empty()) return;
  Interests older;
  {
    const std::lock_guard lock(mutex_);
    if (asked_.size() >= many_keys) std::erase_if(asked_, [](const auto& entry) { return is_answered(entry.second); });
    Asked& asked = asked_[key];
    if (arrived < asked.newest) {
      if (interest) older.push_back(interest);
    } else {
      asked.newest = arrived;
      std::erase_if(asked.interests, [&](const std::weak_ptr<Flights::Interest>& weak) {
        const auto known = weak.lock();
        if (known == nullptr) return true;
        if (how == Superseding::after_current && known->has_begun()) return false;
        older.push_back(known);
        return true;
      });
      if (interest) asked.interests.push_back(interest);
    }
  }
  for (const auto& interested : older) interested->stop(StopReason::superseded);
}

}  // namespace dini::jobs
