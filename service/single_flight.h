#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "geometry/cancel.h"

namespace dini {

/// Lets identical concurrent work run once: the first caller with a key computes, the others wait for its result.
///
/// A waiter gives up when its own `cancel` stops. When the caller that computes is stopped while others wait, one of
/// those computes anew, so nobody's answer depends on somebody else's patience.
template <class Answer>
class SingleFlight {
 public:
  using Work = std::function<Answer(const Cancel&)>;

  Answer run(const std::string& key, const Cancel& cancel, const Work& work) {
    while (true) {
      bool first = false;
      const std::shared_ptr<Flight> flight = join(key, first);
      if (first) return lead(key, *flight, cancel, work);
      if (std::optional<Answer> answer = wait(*flight, cancel)) return *std::move(answer);
      if (cancel.stopped()) return work(cancel);  // reports why, without computing
    }
  }

 private:
  struct Flight {
    std::mutex mutex;
    std::condition_variable landed;
    bool done = false;
    std::optional<Answer> answer;  ///< stays empty when the work was stopped
  };

  std::shared_ptr<Flight> join(const std::string& key, bool& first) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Flight>& flight = flights_[key];
    first = flight == nullptr;
    if (first) flight = std::make_shared<Flight>();
    return flight;
  }

  /// Ends the flight however the work ends, so that waiters never hang on an exception.
  Answer lead(const std::string& key, Flight& flight, const Cancel& cancel, const Work& work) {
    struct Landing {
      SingleFlight& self;
      const std::string& key;
      Flight& flight;
      std::optional<Answer> answer = std::nullopt;
      ~Landing() {
        {
          const std::lock_guard lock(self.mutex_);
          self.flights_.erase(key);
        }
        const std::lock_guard lock(flight.mutex);
        flight.answer = std::move(answer);
        flight.done = true;
        flight.landed.notify_all();
      }
    } landing{*this, key, flight};
    Answer answer = work(cancel);
    if (!cancel.stopped()) landing.answer = answer;
    return answer;
  }

  static std::optional<Answer> wait(Flight& flight, const Cancel& cancel) {
    constexpr auto patience = std::chrono::milliseconds(10);
    std::unique_lock lock(flight.mutex);
    while (!flight.done && !cancel.stopped()) flight.landed.wait_for(lock, patience);
    return flight.answer;
  }

  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Flight>> flights_;
};

}  // namespace dini
