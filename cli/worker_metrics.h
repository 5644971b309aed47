#pragma once

#include <memory>
#include <string>

#include "graph/problem.h"
#include "jobs/worker.h"

namespace dini::cli {

/// The numbers of a worker for Prometheus, at `http://ADDRESS/metrics` as long as this exists.
class WorkerMetrics {
 public:
  /// `address` is a port, of this machine alone, or HOST:PORT. The worker must exist for longer. Problems: `usage`
  /// where the address is none, `address` where it cannot be listened at.
  static Result<WorkerMetrics> serve(const std::string& address, const jobs::Worker& worker,
                                     const std::string& version);

  WorkerMetrics(WorkerMetrics&&) noexcept;
  ~WorkerMetrics();

 private:
  struct Served;
  explicit WorkerMetrics(std::unique_ptr<Served> served);

  std::unique_ptr<Served> served_;
};

}  // namespace dini::cli
