#pragma once

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

namespace dini::cli {

/// The signals that end a server: SIGTERM, SIGINT, and SIGHUP when its terminal is closed. One thread waits for them.
///
/// While the server starts, the first one ends the program at once: there is nothing to lose yet. While it runs, the
/// first one is told to `wait`, and a second one ends the program at once, for those who will not wait for the requests
/// that still run. If the program has not ended by itself when `patience` is over, it is ended.
class EndingSignals {
 public:
  /// To be made before any other thread, so that no other gets the signals.
  explicit EndingSignals(std::chrono::milliseconds patience);
  ~EndingSignals();
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

  /// From now on there is something to lose.
  void running();

  /// Returns at the first signal.
  void wait();

 private:
  void watch();

  const std::chrono::milliseconds patience_;
  sigset_t signals_{};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_running_ = false;
  bool received_ = false;
  bool finished_ = false;
  std::thread thread_;
};

}  // namespace dini::cli
