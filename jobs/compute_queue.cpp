#include "jobs/compute_queue.h"

#include <algorithm>

#include "jobs/memory_reserve.h"

namespace dini::jobs {

ComputeQueue::ComputeQueue(const Size& size, std::function<void()> when_idle)
    : size_(size), when_idle_(std::move(when_idle)) {
  threads_.reserve(size_.places);
  for (std::size_t i = 0; i < size_.places; ++i) threads_.emplace_back([this] { work(); });
}

ComputeQueue::~ComputeQueue() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

bool ComputeQueue::add(const std::shared_ptr<Task>& task) {
  {
    const std::lock_guard lock(mutex_);
    // A free place is never refused to anybody while whoever is to take it wakes up.
    const std::size_t work = waiting_work_of(*task);
    const bool is_served_soon = waiting_work_ + work <= size_.waiting_work;
    if (running_ + waiting_.size() >= size_.places + size_.waiting && !is_served_soon) return false;
    task->place_ = waiting_.insert(waiting_.end(), task);
    task->waits_ = true;
    waiting_work_ += work;
  }
  changed_.notify_one();
  return true;
}

bool ComputeQueue::withdraw(const std::shared_ptr<Task>& task) {
  std::list<std::shared_ptr<Task>> withdrawn;  // freed outside the lock
  const std::lock_guard lock(mutex_);
  if (!task->waits_) return false;
  task->waits_ = false;
  waiting_work_ -= waiting_work_of(*task);
  withdrawn.splice(withdrawn.begin(), waiting_, task->place_);
  return true;
}

ComputeQueue::Load ComputeQueue::load() const {
  const std::lock_guard lock(mutex_);
  return {running_, waiting_.size(), bytes_};
}

bool ComputeQueue::may_start() const {
  return !waiting_.empty() && (running_ == 0 || bytes_ + waiting_.front()->bytes_ <= size_.bytes);
}

/// What a task counts among those that wait: what is short is never taken for nothing, what is long never for more than
/// all may be.
std::size_t ComputeQueue::waiting_work_of(const Task& task) const {
  constexpr std::size_t least = 1'000'000;
  return std::min(std::max(task.work_, least), size_.waiting_work + 1);
}

void ComputeQueue::wait_for_work(std::unique_lock<std::mutex>& lock) {
  while (used_ && when_idle_ != nullptr) {
    if (changed_.wait_for(lock, idle_pause, [this] { return has_work(); })) return;
    if (!used_ || running_ > 0) continue;
    used_ = false;
    lock.unlock();
    when_idle_();
    lock.lock();
  }
  changed_.wait(lock, [this] { return has_work(); });
}

void ComputeQueue::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wait_for_work(lock);
    if (waiting_.empty()) return;
    std::list<std::shared_ptr<Task>> taken;
    taken.splice(taken.begin(), waiting_, waiting_.begin());
    const std::size_t bytes = taken.front()->bytes_;
    taken.front()->waits_ = false;
    waiting_work_ -= waiting_work_of(*taken.front());
    ++running_;
    used_ = true;
    bytes_ += bytes;
    lock.unlock();
    MemoryReserve::refill();
    taken.front()->run_();
    taken.clear();
    lock.lock();
    --running_;
    bytes_ -= bytes;
    changed_.notify_all();  // memory that has become free may let others start
  }
}

}  // namespace dini::jobs
