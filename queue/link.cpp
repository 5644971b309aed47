#include "queue/link.h"

namespace dini::queue {
namespace {

/// Between two looks while Redis is well, and while it is not.
constexpr std::chrono::milliseconds well_pause{1000};
constexpr std::chrono::milliseconds trouble_pause{250};

}  // namespace

Link::Link(const Address& address) : address_(address), connection_(address, Patience()) {
  look();
  thread_ = std::thread([this] { watch(); });
}

Link::~Link() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::string Link::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void Link::note(const Fault& fault) {
  const std::lock_guard lock(mutex_);
  trouble_ = fault.detail;
  well_ = false;
}

/// A write, since a Redis without memory still answers to everything else.
void Link::look() {
  const auto answered = connection_.call({"SET", "dini:link", "1", "EX", "60"});
  const std::lock_guard lock(mutex_);
  trouble_ = answered ? "" : answered.error().detail;
  well_ = answered.has_value();
}

void Link::watch() {
  std::unique_lock lock(mutex_);
  while (!stopped_) {
    changed_.wait_for(lock, well_ ? well_pause : trouble_pause, [this] { return stopped_; });
    if (stopped_) return;
    lock.unlock();
    look();
    lock.lock();
  }
}

}  // namespace dini::queue
