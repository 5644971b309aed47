#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "jobs/flights.h"

namespace dini::jobs {

/// The newest request of every `Supersede-Key`. While a slider is dragged each request makes the one before it
/// pointless; the older one is stopped inside its kernels instead of being finished for nobody.
class Supersede {
 public:
  using Clock = std::chrono::steady_clock;

  /// Stops whichever of two requests with a key arrived first: the one that was the newest so far, or this one.
  /// `interest` is null for one that is answered already. To be called once a request is let in or answered, also with
  /// a problem of its own, but never for one that is turned away: then its sender gets nothing from it and would get
  /// nothing from the older one either. An empty key takes no part.
  void take_over(const std::string& key, Clock::time_point arrived, const std::shared_ptr<Flights::Interest>& interest);

 private:
  struct Newest {
    Clock::time_point arrived;
    std::weak_ptr<Flights::Interest> interest;
  };

  std::mutex mutex_;
  std::map<std::string, Newest, std::less<>> newest_;
};

}  // namespace dini::jobs
