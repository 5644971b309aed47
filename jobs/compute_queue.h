#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace dini::jobs {

/// Computes a few things at once, each on a thread of its own, and lets a bounded number wait: connections are cheap
/// and computations are not. First come, first served; but nothing starts before there is room for the memory that it
/// says it will hold.
class ComputeQueue {
 public:
  struct Size {
    std::size_t places = 1;   ///< computations at once, at least one
    std::size_t waiting = 0;  ///< further ones that may wait, however long they take
    std::size_t bytes = 0;    ///< memory of all that run, together
    /// Nanoseconds: still more may wait as long as all that waits is predicted to take no longer. Refusing somebody who
    /// would be served in a moment only makes them ask again.
    std::size_t waiting_work = 0;
  };
  static constexpr std::size_t unknown_work = std::numeric_limits<std::size_t>::max();
  static constexpr std::chrono::milliseconds idle_pause{3000};

  /// `when_idle` is called, by one of its threads, when nothing has run for a while after something did.
  explicit ComputeQueue(const Size& size, std::function<void()> when_idle = nullptr);
  /// Runs what waits, then ends.
  ~ComputeQueue();
  ComputeQueue(const ComputeQueue&) = delete;
  ComputeQueue& operator=(const ComputeQueue&) = delete;

  /// One computation, from being let in to its end.
  class Task {
   public:
    /// `run` must not throw; it is predicted to take `work` nanoseconds.
    Task(std::size_t bytes, std::function<void()> run, std::size_t work = unknown_work)
        : bytes_(bytes), work_(work), run_(std::move(run)) {}

   private:
    friend class ComputeQueue;
    const std::size_t bytes_;
    const std::size_t work_;
    const std::function<void()> run_;
    std::list<std::shared_ptr<Task>>::iterator place_;
    bool waits_ = false;
  };

  /// Lets a task in; false at once when all places and the whole queue are taken. One that needs more memory than there
  /// is for all runs when nothing else does.
  bool add(const std::shared_ptr<Task>& task);

  /// Takes back a task that has not begun; false when it has. What is taken back never runs.
  bool withdraw(const std::shared_ptr<Task>& task);

  struct Load {
    std::size_t running = 0;
    std::size_t waiting = 0;
    std::size_t bytes = 0;  ///< promised to what runs
  };
  Load load() const;
  const Size& size() const { return size_; }

 private:
  void work();
  bool may_start() const;
  std::size_t waiting_work_of(const Task& task) const;
  bool has_work() const { return may_start() || (finished_ && waiting_.empty()); }
  void wait_for_work(std::unique_lock<std::mutex>& lock);

  const Size size_;
  const std::function<void()> when_idle_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::list<std::shared_ptr<Task>> waiting_;
  std::size_t running_ = 0;
  std::size_t bytes_ = 0;
  std::size_t waiting_work_ = 0;
  bool finished_ = false;
  bool used_ = false;  ///< since it was idle last
  std::vector<std::thread> threads_;
};

}  // namespace dini::jobs
