#include "server/running.h"

#include <cstdint>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <vector>

namespace dini::server {

RunningRequests::RunningRequests()
    : changed_event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), watcher_([this] { watch(); }) {}

RunningRequests::~RunningRequests() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  wake();
  watcher_.join();
  ::close(changed_event_);
}

RunningRequests::Entry::Entry(RunningRequests& requests, int socket, const Cancel& cancel)
    : requests_(requests), socket_(socket), cancel_(cancel) {
  {
    const std::lock_guard lock(requests_.mutex_);
    position_ = requests_.entries_.insert(requests_.entries_.end(), this);
  }
  requests_.wake();
}

RunningRequests::Entry::~Entry() {
  const std::lock_guard lock(requests_.mutex_);
  requests_.entries_.erase(position_);
}

void RunningRequests::stop_all(StopReason reason) {
  const std::lock_guard lock(mutex_);
  for (const Entry* entry : entries_) entry->cancel_.stop(reason);
}

std::size_t RunningRequests::count() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

void RunningRequests::wake() const {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(changed_event_, &one, sizeof one);
}

void RunningRequests::watch() {
  std::vector<pollfd> waits;
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (finished_) return;
      waits.assign(1, {changed_event_, POLLIN, 0});
      for (const Entry* entry : entries_) {
        // A stopped request has nothing more to learn, and its hung-up socket would be reported without end.
        if (entry->cancel_.reason() == StopReason::none) waits.push_back({entry->socket_, POLLRDHUP, 0});
      }
    }
    if (::poll(waits.data(), waits.size(), -1) <= 0) continue;
    std::uint64_t count = 0;
    [[maybe_unused]] const ssize_t drained = ::read(changed_event_, &count, sizeof count);

    // A request may have ended and its descriptor been given to another since poll() returned; asking again under the
    // lock, where no request can end, tells.
    const std::lock_guard lock(mutex_);
    for (const Entry* entry : entries_) {
      pollfd now{entry->socket_, POLLRDHUP, 0};
      if (::poll(&now, 1, 0) > 0) entry->cancel_.stop(StopReason::client_gone);
    }
  }
}

}  // namespace dini::server
