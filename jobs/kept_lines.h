#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "jobs/sweep.h"
#include "store/job_store.h"

namespace dini::jobs {

/// Keeps the lines of a sweep that is a job, many of them at once.
class KeptLines final : public LineTaker {
 public:
  struct Terms {
    std::string id;                                      ///< of the job
    std::size_t first = 0;                               ///< so many lines are kept already
    std::size_t total = 0;                               ///< of all variants
    std::function<void(double)> written;                 ///< told how far it is, from 0 to 1
    std::function<void(const Problems& reasons)> ended;  ///< told once; no reasons when all lines are kept
  };

  KeptLines(store::JobStore& jobs, Terms terms);

  bool take(store::JobLine line) override;
  bool has_room(std::function<void()>) override { return true; }
  void end(const Problems& reasons, std::size_t) override;

 private:
  using Clock = std::chrono::steady_clock;

  bool write();

  store::JobStore& jobs_;
  const Terms terms_;
  std::size_t taken_;
  std::vector<store::JobLine> lines_;
  std::size_t bytes_ = 0;
  Clock::time_point written_ = Clock::now();
  Problems failure_;
};

/// How much of a sweep is done, from 0 to 1.
double share_done(std::size_t done, std::size_t total);

}  // namespace dini::jobs
