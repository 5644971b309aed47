#include "tests/work_count/work_count.h"

#include <atomic>
#include <limits>

namespace {

constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint32_t counted_at_once = 1024;

std::atomic<std::uint64_t> done = 0;
std::atomic<std::uint64_t> alarm_at = never;
std::atomic<std::uint64_t> stopped_at = 0;
std::atomic<const dini::Cancel*> to_stop = nullptr;
thread_local std::uint32_t counted_here = 0;

void count_many() {
  const std::uint64_t now = done.fetch_add(counted_at_once, std::memory_order_relaxed) + counted_at_once;
  std::uint64_t alarm = alarm_at.load(std::memory_order_relaxed);
  if (now < alarm || !alarm_at.compare_exchange_strong(alarm, never)) return;
  stopped_at = now;
  to_stop.load()->stop(dini::StopReason::superseded);
}

}  // namespace

/// Called by the compiler's code at every basic block of what is counted.
extern "C" void __sanitizer_cov_trace_pc() {
  if (++counted_here % counted_at_once == 0) count_many();
}

namespace dini::support {

std::uint64_t work_done() { return done; }

void stop_after(const Cancel& cancel, std::uint64_t work) {
  to_stop = &cancel;
  stopped_at = 0;
  alarm_at = done + work;
}

std::uint64_t work_at_stop() { return stopped_at; }

}  // namespace dini::support
