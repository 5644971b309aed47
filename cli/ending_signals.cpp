#include "cli/ending_signals.h"

#include <cstdlib>
#include <pthread.h>

#include "cli/exit_codes.h"

namespace dini::cli {
namespace {

timespec to_timespec(std::chrono::milliseconds time) {
  return {static_cast<time_t>(time.count() / 1000), static_cast<long>(time.count() % 1000 * 1'000'000)};
}

}  // namespace

EndingSignals::EndingSignals(std::chrono::milliseconds patience) : patience_(patience) {
  sigemptyset(&signals_);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals_, signal);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  thread_ = std::thread([this] { watch(); });
}

EndingSignals::~EndingSignals() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

void EndingSignals::running() {
  const std::lock_guard lock(mutex_);
  is_running_ = true;
}

void EndingSignals::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return received_; });
}

void EndingSignals::watch() {
  int signal = 0;
  sigwait(&signals_, &signal);
  {
    const std::lock_guard lock(mutex_);
    if (finished_) return;
    if (!is_running_) std::_Exit(exit_ok);
    received_ = true;
  }
  changed_.notify_all();
  const timespec patience = to_timespec(patience_);
  signal = sigtimedwait(&signals_, nullptr, &patience);
  const std::lock_guard lock(mutex_);
  if (!finished_) std::_Exit(signal > 0 ? 128 + signal : exit_ok);
}

}  // namespace dini::cli
