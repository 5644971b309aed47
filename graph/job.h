#pragma once

#include <atomic>
#include <cstdint>

#include "geometry/cancel.h"

namespace dini {

/// How far a piece of work is, in units of about a nanosecond of one processor. Told by those who do it, read by
/// anybody at any time. It never goes back as long as everything is announced before the first of it is done.
class Progress {
 public:
  struct State {
    std::uint64_t done = 0;
    std::uint64_t announced = 0;
  };

  void announce(double units) const { announced_.fetch_add(whole(units), std::memory_order_relaxed); }
  void add(double units) const { done_.fetch_add(whole(units), std::memory_order_relaxed); }

  State state() const {
    const std::uint64_t done = done_.load(std::memory_order_relaxed);
    return {done, announced_.load(std::memory_order_relaxed)};
  }

 private:
  static std::uint64_t whole(double units) { return units > 0 ? static_cast<std::uint64_t>(units) : 0; }

  mutable std::atomic<std::uint64_t> done_ = 0;
  mutable std::atomic<std::uint64_t> announced_ = 0;
};

/// A piece of work as those who do it see it: whether to go on, and where to tell how far they are. What makes it stop
/// (a deadline, a newer request, a client that leaves, a shutdown) are watchers from outside; see jobs/flights.h.
struct Job {
  Cancel cancel = {};
  Progress progress = {};
};

}  // namespace dini
