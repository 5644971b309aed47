#include "jobs/kept_lines.h"

namespace dini::jobs {
namespace {

/// Lines are written together: as many as come in this time, or are so large.
constexpr std::chrono::milliseconds line_time{200};
constexpr std::size_t line_bytes = std::size_t{8} << 20;

}  // namespace

double share_done(std::size_t done, std::size_t total) {
  return total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total);
}

KeptLines::KeptLines(store::JobStore& jobs, Terms terms)
    : jobs_(jobs), terms_(std::move(terms)), taken_(terms_.first) {}

bool KeptLines::take(store::JobLine line) {
  bytes_ += line.text.size();
  for (const SharedFile& file : line.files) bytes_ += file->bytes->size();
  lines_.push_back(std::move(line));
  ++taken_;
  if (bytes_ < line_bytes && Clock::now() < written_ + line_time) return true;
  return write();
}

void KeptLines::end(const Problems& reasons, std::size_t) {
  write();
  terms_.ended(failure_.empty() ? reasons : failure_);
}

/// False when it cannot be: then there is no use in going on.
bool KeptLines::write() {
  if (!lines_.empty()) {
    const auto written = jobs_.add_lines(terms_.id, lines_);
    if (!written) failure_ = written.problems();
  }
  lines_.clear();
  bytes_ = 0;
  written_ = Clock::now();
  terms_.written(share_done(taken_, terms_.total));
  return failure_.empty();
}

}  // namespace dini::jobs
