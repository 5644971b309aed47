#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace dini::cli {

/// Does so many pieces of work, `at_once` at a time, and tells of each on the calling thread, in their order and as
/// soon as it is done and those before it were told. What one throws is thrown when it would be told; no further one is
/// begun then.
template <class Outcome>
void do_in_order(std::size_t count, std::size_t at_once, const std::function<Outcome(std::size_t)>& work,
                 const std::function<void(std::size_t, Outcome)>& told) {
  std::vector<std::packaged_task<Outcome()>> tasks;
  std::vector<std::future<Outcome>> outcomes;
  for (std::size_t index = 0; index < count; ++index) {
    outcomes.push_back(tasks.emplace_back([&work, index] { return work(index); }).get_future());
  }
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < std::min(at_once, count); ++i) {
    workers.emplace_back([&] {
      for (std::size_t index = next++; index < count; index = next++) tasks[index]();
    });
  }
  // However this ends, no worker begins anything after it.
  struct Last {
    std::atomic<std::size_t>& next;
    std::size_t count;
    ~Last() { next = count; }
  } const last{next, count};
  for (std::size_t index = 0; index < count; ++index) told(index, outcomes[index].get());
}

}  // namespace dini::cli
