#include "server/gate.h"

#include <chrono>
#include <utility>

namespace dini::server {
namespace {

/// A Cancel cannot wake anybody, so those who wait look at it this often.
constexpr std::chrono::milliseconds look_again{5};

}  // namespace

Result<Gate::Pass> Gate::enter(const Cancel& cancel) {
  std::unique_lock lock(mutex_);
  if (waiting_.empty() && free_ > 0) {
    --free_;
    return Pass(*this);
  }
  if (waiting_.size() >= queue_) {
    return Problem{.code = "busy",
                   .detail = "All " + std::to_string(queue_) +
                             " places in the queue for a computation are taken; try again in a moment."};
  }
  const auto ticket = waiting_.insert(waiting_.end(), Ticket{});
  while (ticket != waiting_.begin() || free_ == 0) {
    if (cancel.stopped()) {
      waiting_.erase(ticket);
      changed_.notify_all();
      return stopped_problem(cancel.reason());
    }
    changed_.wait_for(lock, look_again);
  }
  waiting_.erase(ticket);
  --free_;
  changed_.notify_all();
  return Pass(*this);
}

void Gate::leave() {
  {
    const std::lock_guard lock(mutex_);
    ++free_;
  }
  changed_.notify_all();
}

Problem stopped_problem(StopReason reason) {
  switch (reason) {
    case StopReason::deadline:
      return {.code = "deadline", .detail = "The deadline passed before the evaluation was done."};
    case StopReason::superseded:
      return {.code = "superseded", .detail = "A newer request with the same Supersede-Key arrived."};
    case StopReason::client_gone:
      return {.code = "client-gone", .detail = "The client closed the connection."};
    case StopReason::shutting_down:
    case StopReason::none:
      break;
  }
  return {.code = "shutting-down", .detail = "The server is shutting down."};
}

}  // namespace dini::server
