#include "jobs/queued_sweep.h"

#include <algorithm>

#include "graph/stopped.h"
#include "jobs/line_record.h"
#include "jobs/sweep_line.h"
#include "queue/sealed.h"

namespace dini::jobs {
namespace {

/// While lines come, at most while a few come (each time costs Redis as much as a variant does) and while none comes,
/// and while Redis is away.
constexpr std::chrono::milliseconds short_pause{4};
constexpr std::chrono::milliseconds calm_pause{12};
constexpr std::chrono::milliseconds long_pause{40};
constexpr std::chrono::milliseconds trouble_pause{200};
/// Fewer at once, and no worker waits: each has four variants before it.
constexpr std::size_t few_lines = 4;
/// So many at once, and workers may be waiting for the next variants.
constexpr std::size_t many_lines = 6;
/// The sweep must be asked about so often that it is not taken for abandoned, even while nobody takes its lines.
constexpr std::chrono::milliseconds room_pause{1000};

/// How far lines may come before their turn: so many, and so many bytes.
constexpr std::size_t most_early = 4096;
constexpr std::size_t most_early_bytes = std::size_t{64} << 20;

/// How long to wait after so many lines, when the last wait was so long.
std::chrono::milliseconds pause_after(std::size_t lines, std::chrono::milliseconds waited) {
  if (lines >= few_lines) return short_pause;
  return std::min(std::max(short_pause, 2 * waited), lines == 0 ? long_pause : calm_pause);
}

std::size_t bytes_of(const store::JobLine& line) {
  std::size_t bytes = line.text.size();
  for (const SharedFile& file : line.files) bytes += file->bytes->size();
  return bytes;
}

Problem poisoned(std::size_t index) {
  return {.code = "poisoned-input",
          .detail = "variant " + std::to_string(index) +
                    " ended every worker that was given it, or took it beyond all patience; `dini queue dead` lists it",
          .in_request = true};
}

}  // namespace

QueuedSweep::QueuedSweep(SweepRequest request, queue::QueuedSweep queued, queue::SweepTasks tasks, std::string version,
                         std::vector<OfferedFile> files, std::unique_ptr<LineTaker> taker, QueueCounts& counts)
    : request_(std::move(request)),
      queued_(std::move(queued)),
      tasks_(std::move(tasks)),
      version_(std::move(version)),
      files_(std::move(files)),
      taker_(std::move(taker)),
      counts_(counts),
      next_(request_.first) {}

queue::Answered<queue::SweepTasks::Submitted> QueuedSweep::submit() {
  for (const OfferedFile& file : files_) {
    if (auto offered = tasks_.offer_file(file.sha256, *file.bytes); !offered) return std::move(offered).error();
  }
  std::vector<std::size_t> have;
  for (const auto& [index, line] : early_) have.push_back(index);
  queue::QueuedSweep left = queued_;
  left.first = next_;
  auto submitted = tasks_.submit(left, have);
  is_submitted_ = submitted && *submitted == queue::SweepTasks::Submitted::taken;
  if (is_submitted_) ++counts_.submitted;
  return submitted;
}

void QueuedSweep::start() {
  {
    const std::lock_guard lock(mutex_);
    is_started_ = true;
  }
  changed_.notify_all();
}

void QueuedSweep::stop(StopReason reason) {
  {
    const std::lock_guard lock(mutex_);
    if (reason_ == StopReason::none) reason_ = reason;
  }
  changed_.notify_all();
}

void QueuedSweep::resume() {
  {
    const std::lock_guard lock(mutex_);
    has_room_ = true;
  }
  changed_.notify_all();
}

bool QueuedSweep::has_ended() const {
  const std::lock_guard lock(mutex_);
  return has_ended_;
}

StopReason QueuedSweep::reason() const {
  const std::lock_guard lock(mutex_);
  if (reason_ == StopReason::none && Clock::now() >= request_.deadline) return StopReason::deadline;
  return reason_;
}

void QueuedSweep::pause(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, time,
                    [this, had_room = has_room_] { return reason_ != StopReason::none || has_room_ != had_room; });
}

/// How far variants may be computed now. What was allowed once stays so.
std::size_t QueuedSweep::limit() const {
  if (early_bytes_ >= most_early_bytes) return allowed_;
  return std::max(allowed_, std::min(queued_.total, next_ + most_early));
}

void QueuedSweep::run() {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return is_started_ || reason_ != StopReason::none; });
  }
  auto waited = short_pause;
  while (reason() == StopReason::none && wanted_ && next_ < queued_.total) {
    if (!ready()) {
      pause(trouble_pause);
      continue;
    }
    const std::size_t lines = collect();
    hand_on();
    waited = pause_after(lines, waited);
    bool has_room = true;
    {
      const std::lock_guard lock(mutex_);
      has_room = has_room_;
    }
    if (has_room && have_.size() >= many_lines) {
      waited = std::chrono::milliseconds::zero();
      continue;
    }
    if (next_ < queued_.total) pause(has_room ? waited : room_pause);
  }
  const StopReason why = reason();
  const bool is_complete = next_ == queued_.total || !wanted_;
  if (is_submitted_) tasks_.drop(queued_.id);
  end(is_complete ? Problems{} : Problems{stopped_problem(why)});
}

/// Whether the queue has the sweep.
bool QueuedSweep::ready() {
  if (is_submitted_) return true;
  allowed_ = next_;
  submit();
  return is_submitted_;
}

/// Takes some lines, and says how many.
std::size_t QueuedSweep::collect() {
  allowed_ = limit();
  const auto collected = tasks_.collect(queued_.id, allowed_, have_);
  if (!collected) {
    pause(trouble_pause);
    return 0;
  }
  have_.clear();
  if (collected->gone) {
    is_submitted_ = false;
    return 0;
  }
  for (const queue::CollectedLine& line : collected->lines) accept(line);
  // Lines that Redis had to let go of, or lost some other way, come again only when they are asked for again.
  if (collected->idle && collected->lines.empty() && next_ + early_.size() < allowed_) is_submitted_ = false;
  return collected->lines.size();
}

void QueuedSweep::accept(const queue::CollectedLine& collected) {
  const std::size_t index = collected.index;
  ++counts_.lines;
  const bool is_known = index < next_ || early_.contains(index);
  if (!is_known) {
    std::optional<store::JobLine> line;
    if (collected.is_dead) {
      line = failed_line(index, request_.variants.at(index), {poisoned(index)});
    } else if (const auto bytes = queue::unsealed(collected.line, line_record_type, version_)) {
      line = read_line_record(index, *bytes);
    }
    if (!line) {
      ++counts_.damaged;
      tasks_.redo(queued_.id, index);
      return;
    }
    early_bytes_ += bytes_of(*line);
    early_.emplace(index, *std::move(line));
  }
  have_.push_back(index);
}

/// Tells the lines whose turn it is, as long as there is room.
void QueuedSweep::hand_on() {
  while (wanted_ && !early_.empty() && early_.begin()->first == next_) {
    {
      const std::lock_guard lock(mutex_);
      if (!has_room_) return;
      has_room_ = false;  // until it says so: it may do that before it has answered
    }
    if (!taker_->has_room([self = shared_from_this()] { self->resume(); })) return;
    {
      const std::lock_guard lock(mutex_);
      has_room_ = true;
    }
    store::JobLine line = std::move(early_.begin()->second);
    early_.erase(early_.begin());
    early_bytes_ -= bytes_of(line);
    ++next_;
    wanted_ = taker_->take(std::move(line));
  }
}

void QueuedSweep::end(const Problems& reasons) {
  taker_->end(reasons, next_);
  const std::lock_guard lock(mutex_);
  has_ended_ = true;
}

}  // namespace dini::jobs
