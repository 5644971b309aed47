#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dini::server {

/// Accepted sockets on their way to the threads that serve them, one thread per open connection. Threads start when
/// first needed. The queue is bounded: whoever does not fit is told so at once rather than kept waiting.
class ConnectionQueue {
 public:
  /// `serve` gets a descriptor and owns it.
  ConnectionQueue(std::size_t threads, std::size_t waiting, std::function<void(int)> serve);
  ~ConnectionQueue() { finish(); }
  ConnectionQueue(const ConnectionQueue&) = delete;
  ConnectionQueue& operator=(const ConnectionQueue&) = delete;

  /// False when full; the caller keeps the descriptor.
  bool push(int descriptor);

  /// True while connections wait for a thread: idle ones should make room.
  bool crowded() const { return crowded_.load(std::memory_order_relaxed); }

  /// Serves what is queued, then joins every thread.
  void finish();

 private:
  void work();

  std::size_t thread_limit_;
  std::size_t waiting_limit_;
  std::function<void(int)> serve_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<int> waiting_;
  std::vector<std::thread> threads_;
  std::size_t idle_ = 0;
  bool finishing_ = false;
  std::atomic<bool> crowded_ = false;
};

}  // namespace dini::server
