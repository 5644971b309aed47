#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "graph/job.h"
#include "jobs/sweep_request.h"
#include "queue/task_taker.h"

namespace dini::jobs {

/// Computes variants of sweeps that a queue gives it, each on one thread, until it is told to stop. It may end at any
/// moment, in any way: what it has not told is given to another.
class Worker {
 public:
  struct Terms {
    queue::Address address;
    std::size_t threads = 1;
    std::chrono::milliseconds silence{15'000};  ///< see queue::TaskTaker
  };

  /// What it did since it began.
  struct Counts {
    std::size_t counted = 0;  ///< variants whose line was taken
    std::size_t in_vain = 0;  ///< computed, but others were quicker, or nobody wants it any more
    double seconds = 0;       ///< spent with variants, over all threads
    std::size_t running = 0;  ///< variants at this moment
  };

  Worker(const Engine& engine, const Terms& terms);
  /// Finishes what is being computed.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Begins. Tells why the queue does not let it, if that is so: Redis is away, or does not take the password.
  queue::Answered<bool> start();

  const std::string& name() const { return name_; }
  Counts counts() const;

 private:
  struct Running {
    queue::Task task;
    std::shared_ptr<const Job> job;
  };
  /// A sweep as it was read.
  struct Known {
    SweepRequest request;
    std::string base_path;
    std::vector<std::string> files;
  };
  using SharedKnown = std::shared_ptr<const Known>;

  queue::TaskTaker taker() const;
  void work();
  void beat();
  void compute(queue::TaskTaker& taker, const queue::Task& task);
  void enter(const queue::Task& task);
  void leave(const queue::Task& task);
  std::optional<std::string> line_of(queue::TaskTaker& taker, const queue::Task& task, const Job& job);
  SharedKnown known_sweep(queue::TaskTaker& taker, const std::string& id);
  bool has_files(queue::TaskTaker& taker, const Known& known);
  bool tell(queue::TaskTaker& taker, const queue::Task& task, const Job& job, const std::string& line);
  bool is_stopped() const;
  void pause(std::chrono::milliseconds time);

  const Engine& engine_;
  const Terms terms_;
  const std::string name_;
  const std::string identity_;
  const std::string version_;
  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  bool stopped_ = false;
  bool beats_ = true;
  std::list<Running> running_;
  Counts counts_;
  std::size_t computing_ = 0;
  std::size_t suspects_ = 0;                              ///< that wait to be computed
  bool is_suspected_ = false;                             ///< one is computed
  std::list<std::pair<std::string, SharedKnown>> known_;  ///< the last few sweeps, the latest first
  std::vector<std::thread> threads_;
  std::thread beating_;
};

}  // namespace dini::jobs
