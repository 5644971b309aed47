#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "jobs/flights.h"

namespace dini::jobs {

/// What a newer request does to an older one of its key that is being computed: stops it, or lets it be finished. One
/// that only waits is stopped by both.
enum class Superseding { at_once, after_current };

/// The requests of every `Supersede-Key` that are not answered. While a slider is dragged each request makes the one
/// before it pointless; the older one is stopped inside its kernels instead of being finished for nobody. Or, for who
/// wants to see frames during a drag that never rests, what runs is finished and only what waits is replaced: then as
/// many run as there are places, and one waits.
class Supersede {
 public:
  using Clock = std::chrono::steady_clock;

  /// Stops whichever of two requests with a key arrived first: those that were there so far, or this one.
  /// `interest` is null for one that is answered already. To be called once a request is let in or answered, also with
  /// a problem of its own, but never for one that is turned away: then its sender gets nothing from it and would get
  /// nothing from the older one either. An empty key takes no part.
  void take_over(const std::string& key, Clock::time_point arrived, const std::shared_ptr<Flights::Interest>& interest,
                 Superseding how = Superseding::at_once);

 private:
  using Interests = std::vector<std::shared_ptr<Flights::Interest>>;

  struct Asked {
    Clock::time_point newest;
    std::vector<std::weak_ptr<Flights::Interest>> interests = {};
  };

  std::mutex mutex_;
  std::map<std::string, Asked, std::less<>> asked_;
};

}  // namespace dini::jobs
