#include "jobs/queued_sweeps.h"

#include "jobs/queue_identity.h"
#include "jobs/random_id.h"
#include "store/asset_references.h"

namespace dini::jobs {
namespace {

using Submitted = queue::SweepTasks::Submitted;

/// What a sweep allows Redis: its thread waits for nobody's answer.
constexpr queue::Patience patience{std::chrono::milliseconds(250), std::chrono::milliseconds(1000)};

Problem away(const std::string& why) {
  return {.code = "queue-failed", .detail = "The queue cannot take the sweep just now: " + why + "."};
}

/// Why a sweep was not taken in.
Problem refusal(const queue::Answered<Submitted>& submitted, const std::string& identity) {
  if (!submitted) return away(submitted.error().detail);
  if (*submitted == Submitted::full) {
    return {.code = "busy", .detail = "As many sweeps are at the queue as may be; try again later."};
  }
  return away("no worker of " + identity + " is there");
}

}  // namespace

QueuedSweeps::QueuedSweeps(const Engine& engine, queue::Link& link, std::string base_path)
    : engine_(engine),
      link_(link),
      identity_(queue_identity(engine)),
      about_(dump(Json{{"base_path", std::move(base_path)}})) {}

QueuedSweeps::~QueuedSweeps() { QueuedSweeps::finish(); }

void QueuedSweeps::finish() {
  stop_all(StopReason::shutting_down);
  std::list<Running> running;
  {
    const std::lock_guard lock(mutex_);
    running.swap(running_);
  }
  for (Running& each : running) each.thread.join();
}

/// The mesh files that a request names, as far as they are here.
std::vector<OfferedFile> QueuedSweeps::files_of(const std::string& text) const {
  std::vector<OfferedFile> files;
  for (const Digest& named : store::assets_named_in(text)) {
    std::string sha256 = to_hex(named);
    if (SharedBytes bytes = engine_.asset(sha256)) files.push_back({std::move(sha256), std::move(bytes)});
  }
  return files;
}

void QueuedSweeps::let_go_of_ended() {
  for (auto running = running_.begin(); running != running_.end();) {
    if (!running->sweep->has_ended()) {
      ++running;
      continue;
    }
    running->thread.join();
    running = running_.erase(running);
  }
}

Result<std::shared_ptr<Sweep>> QueuedSweeps::make(const SweepRequest& request, const SweepCost&,
                                                  std::unique_ptr<LineTaker> taker, Waiting waiting) {
  const bool is_awaited = waiting == Waiting::answer;
  if (is_awaited && !link_.is_well()) return away(link_.trouble());
  queue::QueuedSweep queued{.id = random_id(),
                            .lane = is_awaited ? queue::Lane::interactive : queue::Lane::batch,
                            .body = *request.text,
                            .about = about_,
                            .total = request.variants.size(),
                            .first = request.first};
  std::vector<OfferedFile> files = files_of(*request.text);
  if (!files.empty()) {
    Json about = Json::parse(about_);
    for (const OfferedFile& file : files) about["files"].push_back(file.sha256);
    queued.about = dump(about);
  }
  const auto sweep =
      std::make_shared<QueuedSweep>(request, std::move(queued), queue::SweepTasks(link_.address(), patience, identity_),
                                    version_of(engine_), std::move(files), std::move(taker), counts_);
  if (is_awaited) {
    const auto submitted = sweep->submit();
    if (!submitted) link_.note(submitted.error());
    if (!submitted || *submitted != Submitted::taken) return refusal(submitted, identity_);
  }
  const std::lock_guard lock(mutex_);
  let_go_of_ended();
  running_.push_back({sweep, std::thread([sweep] { sweep->run(); })});
  return std::shared_ptr<Sweep>(sweep);
}

void QueuedSweeps::stop_all(StopReason reason) {
  const std::lock_guard lock(mutex_);
  for (const Running& running : running_) running.sweep->stop(reason);
}

}  // namespace dini::jobs
