#include "jobs/shared_results.h"

#include <algorithm>
#include <thread>

#include "graph/digest.h"
#include "graph/stopped.h"
#include "jobs/compute_queue.h"
#include "jobs/queue_identity.h"

namespace dini::jobs {
namespace {

using std::chrono::milliseconds;

/// What is computed sooner than this is not worth a question to another machine.
constexpr std::size_t least_work = 2'000'000;
/// How long another is given before it is taken for lost: what was predicted, several times, and within bounds.
constexpr milliseconds least_lease{500}, most_lease{10'000};
constexpr milliseconds first_pause{2}, longest_pause{50};

milliseconds lease_time(std::size_t work) {
  constexpr std::size_t generous = 4, nanoseconds = 1'000'000;
  const std::size_t bounded = std::min(work, std::size_t{10'000'000'000});
  return std::clamp(milliseconds(generous * bounded / nanoseconds), least_lease, most_lease);
}

}  // namespace

SharedResults::SharedResults(const Engine& engine, queue::Link& link)
    : engine_(engine), store_(link, version_of(engine)) {}

SharedComputed SharedResults::find(const std::string& key, const Prepared& prepared) {
  const auto kept = store_.find(key);
  return kept ? engine_.restore(prepared, *kept) : nullptr;
}

SharedComputed SharedResults::wait_for_another(const std::string& key, const Prepared& prepared, milliseconds time,
                                               const Job& job) {
  const auto until = std::chrono::steady_clock::now() + time;
  milliseconds pause = first_pause;
  while (!job.cancel.stopped() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, longest_pause);
    if (SharedComputed known = find(key, prepared)) return known;
    if (store_.lease(key, time)) return nullptr;
  }
  return nullptr;
}

Result<SharedComputed> SharedResults::compute(const Prepared& prepared, const Job& job) {
  if (prepared.work < least_work || !engine_.is_shareable(prepared)) return engine_.compute(prepared, job);
  const std::string key = to_hex(prepared.content);
  if (SharedComputed known = find(key, prepared)) return known;
  const milliseconds time = lease_time(prepared.work);
  if (!store_.lease(key, time)) {
    if (SharedComputed known = wait_for_another(key, prepared, time, job)) return known;
    if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
  }
  auto computed = engine_.compute(prepared, job);
  if (computed) store_.keep(key, engine_.kept_form(prepared, **computed));
  store_.release(key);
  return computed;
}

}  // namespace dini::jobs
