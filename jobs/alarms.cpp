#include "jobs/alarms.h"

namespace dini::jobs {

Alarms::Alarms() : thread_([this] { work(); }) {}

Alarms::~Alarms() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Alarms::Alarm& Alarms::Alarm::operator=(Alarm&& other) noexcept {
  take_back();
  alarms_ = std::exchange(other.alarms_, nullptr);
  key_ = other.key_;
  return *this;
}

void Alarms::Alarm::take_back() {
  Alarms* alarms = std::exchange(alarms_, nullptr);
  if (alarms == nullptr) return;
  std::unique_lock lock(alarms->mutex_);
  alarms->waiting_.erase(key_);
  if (std::this_thread::get_id() == alarms->thread_.get_id()) return;
  alarms->rung_.wait(lock, [&] { return alarms->ringing_ != key_; });
}

Alarms::Alarm Alarms::at(Clock::time_point time, std::function<void()> ring) {
  const std::lock_guard lock(mutex_);
  const Alarm::Key key{time, ++count_};
  const auto place = waiting_.emplace(key, std::move(ring)).first;
  if (place == waiting_.begin()) changed_.notify_all();
  return {*this, key};
}

void Alarms::work() {
  std::unique_lock lock(mutex_);
  while (!finished_) {
    if (waiting_.empty()) {
      changed_.wait(lock);
      continue;
    }
    const auto next = waiting_.begin();
    const Clock::time_point time = next->first.first;
    if (Clock::now() < time) {
      changed_.wait_until(lock, time);
      continue;
    }
    auto ringing = waiting_.extract(next);
    ringing_ = ringing.key();
    lock.unlock();
    try {
      ringing.mapped()();
    } catch (...) {
      // Nothing is to be done about it here, and the other alarms must ring.
    }
    lock.lock();
    ringing_ = {};
    rung_.notify_all();
  }
}

}  // namespace dini::jobs
