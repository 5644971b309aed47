#pragma once

#include <condition_variable>
#include <cstddef>
#include <list>
#include <mutex>
#include <utility>

#include "geometry/cancel.h"
#include "graph/problem.h"

namespace dini::server {

/// Lets as many requests compute at once as there are slots, in the order they came. A connection is cheap and a
/// computation is not, so the two are limited apart.
class Gate {
 public:
  Gate(std::size_t slots, std::size_t queue) : free_(slots), queue_(queue) {}

  /// A slot, given back at the end of its scope.
  class Pass {
   public:
    explicit Pass(Gate& gate) : gate_(&gate) {}
    Pass(Pass&& other) noexcept : gate_(std::exchange(other.gate_, nullptr)) {}
    Pass& operator=(Pass&&) = delete;
    ~Pass() {
      if (gate_ != nullptr) gate_->leave();
    }

   private:
    Gate* gate_;
  };

  /// Waits for a slot for as long as `cancel` allows. Problems: `busy` at once when the queue is full, or what `cancel`
  /// says.
  Result<Pass> enter(const Cancel& cancel);

 private:
  struct Ticket {};

  void leave();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t free_;
  std::size_t queue_;
  std::list<Ticket> waiting_;
};

/// The problem that a stopped request answers with.
Problem stopped_problem(StopReason reason);

}  // namespace dini::server
