#include "server/answer_threads.h"

#include <algorithm>
#include <utility>

namespace dini::server {

AnswerThreads::AnswerThreads(std::size_t threads) : most_large_(std::max<std::size_t>(1, threads / 2)) {
  threads_.reserve(threads);
  for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

void AnswerThreads::post(std::function<void()> work, Size size) {
  {
    const std::lock_guard lock(mutex_);
    (size == Size::large ? large_ : small_).push_back(std::move(work));
  }
  changed_.notify_one();
}

void AnswerThreads::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
}

void AnswerThreads::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !small_.empty() || may_take_large() || (finished_ && large_.empty()); });
    const bool is_large = small_.empty();
    std::deque<std::function<void()>>& queue = is_large ? large_ : small_;
    if (queue.empty()) return;
    {
      const std::function<void()> work = std::move(queue.front());
      queue.pop_front();
      if (is_large) ++running_large_;
      lock.unlock();
      try {
        work();
      } catch (...) {
        // Whatever it held is let go of, and a call that is let go of without an answer says so itself.
      }
    }
    lock.lock();
    if (!is_large) continue;
    --running_large_;
    changed_.notify_one();
  }
}

}  // namespace dini::server
