#pragma once

#include <atomic>
#include <chrono>

namespace dini {

/// Why work was stopped.
enum class StopReason { none, deadline, superseded, client_gone, shutting_down };

/// The one flag that tells running work to stop. Shared by the request that owns it and every kernel that runs for it:
/// kernels call `stopped()` at least every few thousand elements and return early, with any partial result, when it is
/// true.
class Cancel {
 public:
  using Clock = std::chrono::steady_clock;

  Cancel() = default;
  explicit Cancel(Clock::time_point deadline) : deadline_(deadline) {}
  Cancel(const Cancel&) = delete;
  Cancel& operator=(const Cancel&) = delete;

  /// Asks for a stop; the first reason wins.
  void stop(StopReason reason) const {
    StopReason none = StopReason::none;
    reason_.compare_exchange_strong(none, reason, std::memory_order_relaxed);
  }

  /// True once stopped or past the deadline.
  bool stopped() const {
    if (reason_.load(std::memory_order_relaxed) != StopReason::none) return true;
    if (deadline_ == Clock::time_point::max() || Clock::now() < deadline_) return false;
    stop(StopReason::deadline);
    return true;
  }

  StopReason reason() const { return reason_.load(std::memory_order_relaxed); }

 private:
  Clock::time_point deadline_ = Clock::time_point::max();
  mutable std::atomic<StopReason> reason_ = StopReason::none;
};

}  // namespace dini
