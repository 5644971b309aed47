#include "server/wrong_tokens.h"

#include <algorithm>

namespace dini::server {
namespace {

constexpr double milliseconds_of_all = 60'000;

}  // namespace

std::optional<std::chrono::milliseconds> WrongTokens::count(const std::optional<Address>& sender,
                                                            Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  ++total_;
  // A peer without an address has left; all of those share one.
  Sender& known = sender_of(sender.value_or(Address{}).subscriber(), now);
  const double passed = std::chrono::duration<double, std::milli>(now - known.seen).count();
  known.left = std::min(most_, known.left + passed * most_ / milliseconds_of_all);
  known.seen = now;
  if (known.left >= 1) {
    known.left -= 1;
    return std::nullopt;
  }
  const double wait = (1 - known.left) * milliseconds_of_all / most_;
  return std::chrono::ceil<std::chrono::milliseconds>(std::chrono::duration<double, std::milli>(wait));
}

/// Moved to the front, or put there in place of the one that has been right, or silent, longest.
WrongTokens::Sender& WrongTokens::sender_of(const Address& subscriber, Clock::time_point now) {
  if (const auto place = places_.find(subscriber); place != places_.end()) {
    senders_.splice(senders_.begin(), senders_, place->second);
    return senders_.front();
  }
  if (senders_.size() >= most_senders) {
    places_.erase(senders_.back().subscriber);
    senders_.pop_back();
  }
  senders_.push_front({subscriber, most_, now});
  try {
    places_.emplace(subscriber, senders_.begin());
  } catch (...) {
    senders_.pop_front();
    throw;
  }
  return senders_.front();
}

std::size_t WrongTokens::total() const {
  const std::lock_guard lock(mutex_);
  return total_;
}

std::size_t WrongTokens::senders() const {
  const std::lock_guard lock(mutex_);
  return senders_.size();
}

}  // namespace dini::server
