#pragma once

#include <functional>
#include <memory>

#include "jobs/sweep_request.h"
#include "store/job_store.h"

namespace dini::jobs {

/// Whoever is told what comes of a sweep. One call at a time, on a thread that computes or waits but for `end`, which
/// may be on any.
class LineTaker {
 public:
  virtual ~LineTaker() = default;
  /// The next variant in their order. False when nobody wants any more.
  virtual bool take(store::JobLine line) = 0;
  /// Whether to go on now; if not, `resume` is called once there is room.
  virtual bool has_room(std::function<void()> resume) = 0;
  /// All were told, or there are reasons why not: then `next` is the first one that was not.
  virtual void end(const Problems& reasons, std::size_t next) = 0;
};

/// A sweep that somebody wants, wherever its variants are computed. It lives until it has ended.
class Sweep {
 public:
  virtual ~Sweep() = default;
  /// Begins it. To be called once.
  virtual void start() = 0;
  /// Ends it, unless it has ended. Any thread, any time, more than once.
  virtual void stop(StopReason reason) = 0;
};

/// Where sweeps are computed.
class Sweeps {
 public:
  /// Somebody waits for its lines, or asks about them later.
  enum class Waiting { answer, job };

  virtual ~Sweeps() = default;
  /// A sweep that is to be started. Problems: one that somebody waits for cannot be begun now (`busy`,
  /// `queue-failed`).
  virtual Result<std::shared_ptr<Sweep>> make(const SweepRequest& request, const SweepCost& cost,
                                              std::unique_ptr<LineTaker> taker, Waiting waiting) = 0;
  /// Stops all.
  virtual void stop_all(StopReason reason) = 0;
  /// Stops all, and returns when none tells anybody anything any more.
  virtual void finish() = 0;
};

}  // namespace dini::jobs
