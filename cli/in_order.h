#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace dini::cli {

/// Does so many pieces of work, `at_once` at a time, and tells of each on the calling thread, in their order and as
/// soon as it is done and those before it were told. Neither may throw.
template <class Outcome>
void do_in_order(std::size_t count, std::size_t at_once, const std::function<Outcome(std::size_t)>& work,
                 const std::function<void(std::size_t, Outcome)>& told) {
  std::vector<std::optional<Outcome>> outcomes(count);
  std::mutex mutex;
  std::condition_variable done;
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t index = next++; index < count; index = next++) {
      Outcome outcome = work(index);
      const std::lock_guard lock(mutex);
      outcomes[index] = std::move(outcome);
      done.notify_one();
    }
  };
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < std::min(at_once, count); ++i) workers.emplace_back(worker);
  for (std::size_t index = 0; index < count; ++index) {
    std::unique_lock lock(mutex);
    done.wait(lock, [&] { return outcomes[index].has_value(); });
    Outcome outcome = std::move(*outcomes[index]);
    lock.unlock();
    told(index, std::move(outcome));
  }
}

}  // namespace dini::cli
