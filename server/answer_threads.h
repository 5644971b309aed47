#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dini::server {

/// A few threads that read requests, check them, and write answers. Nothing that runs here waits for anything, so the
/// number of threads also bounds how much memory reading and checking can take at once.
class AnswerThreads {
 public:
  /// Large work, the reading of a large body say, never gets more than half of the threads: small requests do not wait
  /// behind it.
  enum class Size { small, large };

  explicit AnswerThreads(std::size_t threads);
  ~AnswerThreads() { finish(); }
  AnswerThreads(const AnswerThreads&) = delete;
  AnswerThreads& operator=(const AnswerThreads&) = delete;

  /// Runs `work` soon. What it throws is its own concern: it is destroyed then, as after its end.
  void post(std::function<void()> work, Size size = Size::small);

  /// Runs what was posted, then joins every thread.
  void finish();

 private:
  bool may_take_large() const { return !large_.empty() && running_large_ < most_large_; }
  void run();

  const std::size_t most_large_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> small_;
  std::deque<std::function<void()>> large_;
  std::size_t running_large_ = 0;
  bool finished_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace dini::server
