#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "jobs/sweep.h"
#include "queue/sweep_tasks.h"

namespace dini::jobs {

/// What the sweeps of a process that others compute have met so far.
struct QueueCounts {
  std::atomic<std::size_t> lines = 0;      ///< that were taken from the queue
  std::atomic<std::size_t> damaged = 0;    ///< of these, those that were not what they have to be
  std::atomic<std::size_t> submitted = 0;  ///< sweeps, also those that were lost and given again
};

/// A mesh file that workers are offered.
struct OfferedFile {
  std::string sha256;
  SharedBytes bytes;
};

/// A sweep whose variants workers compute. Whatever happens to them or to Redis, each line is told once, and in its
/// order: what is lost is asked for again.
class QueuedSweep final : public Sweep, public std::enable_shared_from_this<QueuedSweep> {
 public:
  /// `files` are those that the graph names, which the workers are offered.
  QueuedSweep(SweepRequest request, queue::QueuedSweep queued, queue::SweepTasks tasks, std::string version,
              std::vector<OfferedFile> files, std::unique_ptr<LineTaker> taker, QueueCounts& counts);

  /// Gives it to the queue. To be called before it is started by who wants to know at once whether it can be.
  queue::Answered<queue::SweepTasks::Submitted> submit();

  /// Lets `run` begin, which must have a thread.
  void start() override;
  void stop(StopReason reason) override;

  /// Does all there is to do, and returns when the sweep has ended.
  void run();
  bool has_ended() const;

 private:
  using Clock = Alarms::Clock;

  bool ready();
  std::size_t collect();
  void accept(const queue::CollectedLine& collected);
  void hand_on();
  std::size_t limit() const;
  void pause(std::chrono::milliseconds time);
  void resume();
  StopReason reason() const;
  void end(const Problems& reasons);

  const SweepRequest request_;
  const queue::QueuedSweep queued_;
  queue::SweepTasks tasks_;
  const std::string version_;
  const std::vector<OfferedFile> files_;
  const std::unique_ptr<LineTaker> taker_;
  QueueCounts& counts_;
  // Of the thread that runs:
  bool is_submitted_ = false;
  std::size_t next_;                             ///< the first variant that was not told
  std::map<std::size_t, store::JobLine> early_;  ///< lines whose turn it is not yet
  std::size_t early_bytes_ = 0;
  std::size_t allowed_ = 0;        ///< no variant from here on was let begin
  std::vector<std::size_t> have_;  ///< lines that came with the last answer
  bool wanted_ = true;
  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  bool is_started_ = false;
  bool has_room_ = true;
  bool has_ended_ = false;
  StopReason reason_ = StopReason::none;
};

}  // namespace dini::jobs
