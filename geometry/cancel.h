#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "algebra/kernels.h"

namespace dini {

/// Why work was stopped.
enum class StopReason { none, deadline, superseded, client_gone, canceled, shutting_down };

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

  /// This flag as the kernels of `algebra/` ask for it. It must outlive their work.
  kernels::Stop for_kernels() const {
    return {this, [](const void* cancel) { return static_cast<const Cancel*>(cancel)->stopped(); }};
  }

 private:
  Clock::time_point deadline_ = Clock::time_point::max();
  mutable std::atomic<StopReason> reason_ = StopReason::none;
};

/// Looks at a flag once in some thousand steps, for loops whose steps take nanoseconds.
class CancelEvery {
 public:
  explicit CancelEvery(const Cancel& cancel) : cancel_(cancel) {}

  /// One step more; true once the flag was seen to be set, at the first step for one that is set already.
  bool stopped() {
    if (steps_++ % 4096 == 0) stopped_ = cancel_.stopped();
    return stopped_;
  }

 private:
  const Cancel& cancel_;
  std::uint32_t steps_ = 0;
  bool stopped_ = false;
};

}  // namespace dini
