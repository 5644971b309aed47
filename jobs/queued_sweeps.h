#pragma once

#include <list>
#include <mutex>
#include <string>
#include <thread>

#include "jobs/queued_sweep.h"
#include "queue/link.h"

namespace dini::jobs {

/// Sweeps that workers compute. Each has a thread here that waits for its lines.
class QueuedSweeps final : public Sweeps {
 public:
  /// The addresses in lines begin with `base_path`.
  QueuedSweeps(const Engine& engine, queue::Link& link, std::string base_path);
  /// Finishes.
  ~QueuedSweeps() override;

  /// One of a job is given to the queue as soon as that takes it.
  Result<std::shared_ptr<Sweep>> make(const SweepRequest& request, const SweepCost& cost,
                                      std::unique_ptr<LineTaker> taker, Waiting waiting) override;
  void stop_all(StopReason reason) override;
  void finish() override;

  const QueueCounts& counts() const { return counts_; }

 private:
  struct Running {
    std::shared_ptr<QueuedSweep> sweep;
    std::thread thread;
  };

  std::vector<OfferedFile> files_of(const std::string& text) const;
  void let_go_of_ended();

  const Engine& engine_;
  queue::Link& link_;
  const std::string identity_;
  const std::string about_;
  QueueCounts counts_;
  std::mutex mutex_;  ///< of what follows
  std::list<Running> running_;
};

}  // namespace dini::jobs
