#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace dini::jobs {

/// Calls functions at given times, on one thread of its own.
class Alarms {
 public:
  using Clock = std::chrono::steady_clock;

  Alarms();
  ~Alarms();
  Alarms(const Alarms&) = delete;
  Alarms& operator=(const Alarms&) = delete;

  /// An alarm that is set. Destroying it takes it back; once that returns, it neither rings nor will, unless it is the
  /// ringing itself that destroys it.
  class Alarm {
   public:
    Alarm() = default;
    Alarm(Alarm&& other) noexcept : alarms_(std::exchange(other.alarms_, nullptr)), key_(other.key_) {}
    Alarm& operator=(Alarm&& other) noexcept;
    ~Alarm() { take_back(); }

   private:
    friend class Alarms;
    using Key = std::pair<Clock::time_point, std::uint64_t>;
    Alarm(Alarms& alarms, const Key& key) : alarms_(&alarms), key_(key) {}
    void take_back();

    Alarms* alarms_ = nullptr;
    Key key_{};
  };

  /// Calls `ring` once, at `time` or as soon after as can be. It must be quick; what it throws is lost.
  [[nodiscard]] Alarm at(Clock::time_point time, std::function<void()> ring);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::condition_variable rung_;
  std::map<Alarm::Key, std::function<void()>> waiting_;
  Alarm::Key ringing_{};
  std::uint64_t count_ = 0;
  bool finished_ = false;
  std::thread thread_;
};

}  // namespace dini::jobs
