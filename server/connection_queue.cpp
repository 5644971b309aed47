#include "server/connection_queue.h"

#include <system_error>
#include <utility>

namespace dini::server {

ConnectionQueue::ConnectionQueue(std::size_t threads, std::size_t waiting, std::function<void(int)> serve)
    : thread_limit_(threads), waiting_limit_(waiting), serve_(std::move(serve)) {}

bool ConnectionQueue::push(int descriptor) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= idle_ && threads_.size() < thread_limit_) {
      try {
        threads_.emplace_back([this] { work(); });
        ++idle_;
      } catch (const std::system_error&) {
        if (threads_.empty()) return false;  // out of threads: those that run must do
      }
    }
    if (waiting_.size() >= waiting_limit_ + idle_) return false;
    waiting_.push_back(descriptor);
    crowded_.store(waiting_.size() > idle_, std::memory_order_relaxed);
  }
  changed_.notify_one();
  return true;
}

void ConnectionQueue::finish() {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
}

void ConnectionQueue::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !waiting_.empty() || finishing_; });
    if (waiting_.empty()) return;
    const int descriptor = waiting_.front();
    waiting_.pop_front();
    --idle_;
    crowded_.store(waiting_.size() > idle_, std::memory_order_relaxed);
    lock.unlock();
    serve_(descriptor);
    lock.lock();
    ++idle_;
    crowded_.store(waiting_.size() > idle_, std::memory_order_relaxed);
  }
}

}  // namespace dini::server
