#include "jobs/worker.h"

#include <algorithm>
#include <new>
#include <spdlog/spdlog.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include "jobs/job_request.h"
#include "jobs/line_record.h"
#include "jobs/queue_identity.h"
#include "jobs/random_id.h"
#include "jobs/sweep_line.h"
#include "jobs/variant_outcome.h"
#include "queue/sealed.h"

namespace dini::jobs {
namespace {

/// How long a worker allows Redis to answer: nobody waits for this one answer.
constexpr queue::Patience worker_patience{std::chrono::milliseconds(1000), std::chrono::milliseconds(5000)};
constexpr std::chrono::milliseconds beat_pause{1000};
constexpr std::chrono::milliseconds idle_wait{1000};
constexpr std::chrono::milliseconds away_pause{200};  ///< before Redis is asked again that did not answer
constexpr std::size_t most_known = 16;
/// How often a variant is computed again whose mesh files had to make room meanwhile.
constexpr int most_tries = 3;

/// No two workers have the same, and whoever reads it finds the process. The number of threads stands last: see
/// queue/scripts/collect.lua.
std::string new_name(std::size_t threads) {
  char host[256] = {};
  ::gethostname(host, sizeof host - 1);
  return std::string(host) + ":" + std::to_string(::getpid()) + ":" + random_id().substr(0, 8) + "/" +
         std::to_string(threads);
}

bool lacks_file(const VariantOutcome& outcome) {
  const Problems problems = outcome.problems();
  return std::ranges::any_of(problems, [](const Problem& problem) { return problem.code == "unknown-asset"; });
}

}  // namespace

Worker::Worker(const Engine& engine, const Terms& terms)
    : engine_(engine),
      terms_(terms),
      name_(new_name(terms.threads)),
      identity_(queue_identity(engine)),
      version_(version_of(engine)) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  {
    const std::lock_guard lock(mutex_);
    beats_ = false;
  }
  changed_.notify_all();
  if (!beating_.joinable()) return;
  beating_.join();
  taker().leave();
}

queue::TaskTaker Worker::taker() const {
  return {terms_.address, worker_patience, {.identity = identity_, .worker = name_, .silence = terms_.silence}};
}

queue::Answered<bool> Worker::start() {
  queue::TaskTaker first = taker();
  if (auto beaten = first.beat({}); !beaten) return std::move(beaten).error();
  beating_ = std::thread([this] { beat(); });
  for (std::size_t i = 0; i < terms_.threads; ++i) threads_.emplace_back([this] { work(); });
  return true;
}

bool Worker::is_stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

void Worker::pause(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, time, [this] { return stopped_; });
}

void Worker::work() {
  queue::TaskTaker taker = this->taker();
  tbb::task_arena alone(1);
  bool is_away = false;
  while (taker.has_next() || !is_stopped()) {
    const auto task = taker.take(idle_wait);
    if (!task) {
      if (!std::exchange(is_away, true)) spdlog::warn("queue: {}", task.error().detail);
      pause(away_pause);
      continue;
    }
    is_away = false;
    if (!*task) continue;
    alone.execute([&] { compute(taker, **task); });
  }
}

/// A variant that may have ended another worker is computed alone, so that no other is blamed if it ends this one.
void Worker::enter(const queue::Task& task) {
  std::unique_lock lock(mutex_);
  if (task.deliveries > 1) {
    ++suspects_;
    changed_.wait(lock, [this] { return computing_ == 0 && !is_suspected_; });
    --suspects_;
    is_suspected_ = true;
  } else {
    changed_.wait(lock, [this] { return suspects_ == 0 && !is_suspected_; });
    ++computing_;
  }
}

void Worker::leave(const queue::Task& task) {
  {
    const std::lock_guard lock(mutex_);
    if (task.deliveries > 1) {
      is_suspected_ = false;
    } else {
      --computing_;
    }
  }
  changed_.notify_all();
}

void Worker::compute(queue::TaskTaker& taker, const queue::Task& task) {
  const auto job = std::make_shared<const Job>();
  std::list<Running>::iterator place;
  {
    const std::lock_guard lock(mutex_);
    place = running_.insert(running_.end(), {task, job});
  }
  enter(task);
  const auto begun = std::chrono::steady_clock::now();
  const auto line = line_of(taker, task, *job);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun;
  leave(task);
  const bool is_counted = line && tell(taker, task, *job, *line);
  const std::lock_guard lock(mutex_);
  running_.erase(place);
  ++(is_counted ? counts_.counted : counts_.in_vain);
  counts_.seconds += spent.count();
}

Worker::Counts Worker::counts() const {
  const std::lock_guard lock(mutex_);
  Counts counts = counts_;
  counts.running = running_.size();
  return counts;
}

/// What came of a variant, sealed; nothing when it is to be left to others or nobody wants it.
std::optional<std::string> Worker::line_of(queue::TaskTaker& taker, const queue::Task& task, const Job& job) try {
  const SharedKnown known = known_sweep(taker, task.sweep);
  if (known == nullptr || task.index >= known->request.variants.size()) return std::nullopt;
  for (int tries = 0; tries < most_tries; ++tries) {
    if (!has_files(taker, *known)) return std::nullopt;
    const VariantOutcome outcome = evaluate_variant(engine_, known->request, task.index, job);
    if (job.cancel.stopped()) return std::nullopt;
    if (!known->files.empty() && lacks_file(outcome)) continue;
    const store::JobLine line = sweep_line(engine_, outcome, known->base_path);
    return queue::sealed(line_record_type, version_, line_record(line));
  }
  return std::nullopt;
} catch (const std::bad_alloc&) {
  engine_.forget();
  spdlog::error("queue: there is no memory for variant {} of sweep {}", task.index, task.sweep);
  return std::nullopt;
} catch (const std::exception& error) {
  spdlog::error("queue: variant {} of sweep {}: {}", task.index, task.sweep, error.what());
  return std::nullopt;
}

/// Tells a line, however long that takes, unless others have the variant by then; whether it was the first.
bool Worker::tell(queue::TaskTaker& taker, const queue::Task& task, const Job& job, const std::string& line) {
  while (!job.cancel.stopped()) {
    const auto then = is_stopped() ? queue::TaskTaker::Then::rest : queue::TaskTaker::Then::take;
    const auto finished = taker.finish(task, line, then);
    if (finished) return *finished == queue::TaskTaker::Finished::counted;
    if (is_stopped()) return false;
    pause(away_pause);
  }
  return false;
}

Worker::SharedKnown Worker::known_sweep(queue::TaskTaker& taker, const std::string& id) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(known_, id, &std::pair<std::string, SharedKnown>::first);
    if (found != known_.end()) {
      known_.splice(known_.begin(), known_, found);
      return found->second;
    }
  }
  const auto told = taker.find(id);
  if (!told || !*told) return nullptr;
  auto json = parse_json((*told)->body, engine_.limits());
  auto read = json ? read_sweep_request(*std::move(json), engine_) : Result<JobRequest>(json.problems());
  const Json about = Json::parse((*told)->about, nullptr, false);
  if (!read || !about.is_object()) {
    spdlog::error("queue: sweep {} cannot be read", id);
    return nullptr;
  }
  const auto known = std::make_shared<const Known>(Known{.request = std::get<SweepRequest>(std::move(read->asked)),
                                                         .base_path = about.value("base_path", ""),
                                                         .files = about.value("files", std::vector<std::string>())});
  const std::lock_guard lock(mutex_);
  known_.emplace_front(id, known);
  if (known_.size() > most_known) known_.pop_back();
  return known;
}

/// Whether the mesh files that a sweep names are here, or can be had.
bool Worker::has_files(queue::TaskTaker& taker, const Known& known) {
  for (const std::string& file : known.files) {
    if (engine_.asset(file) != nullptr) continue;
    const auto offered = taker.offered(file);
    if (!offered || !*offered || to_hex(sha256(**offered)) != file) return false;
    if (!engine_.add_asset(**offered, "", Cancel())) return false;
  }
  return true;
}

/// Tells that all is well, and stops what others have or nobody wants.
void Worker::beat() {
  queue::TaskTaker taker = this->taker();
  std::unique_lock lock(mutex_);
  while (beats_) {
    std::vector<queue::Task> tasks;
    for (const Running& running : running_) tasks.push_back(running.task);
    lock.unlock();
    const auto stop = taker.beat(tasks);
    lock.lock();
    if (stop) {
      for (const Running& running : running_) {
        if (std::ranges::find(*stop, running.task.entry) != stop->end()) running.job->cancel.stop(StopReason::canceled);
      }
    }
    changed_.wait_for(lock, beat_pause, [this] { return !beats_; });
  }
}

}  // namespace dini::jobs
