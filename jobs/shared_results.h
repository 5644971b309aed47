#pragma once

#include "graph/job.h"
#include "queue/result_store.h"
#include "service/engine.h"

namespace dini::jobs {

/// Evaluations whose results the servers of a queue share: what one has computed the others take, and what one computes
/// the others wait for a while. No answer depends on it.
class SharedResults {
 public:
  SharedResults(const Engine& engine, queue::Link& link);

  /// As the engine computes it.
  Result<SharedComputed> compute(const Prepared& prepared, const Job& job);

  const queue::ResultStore::Counts& counts() const { return store_.counts(); }

 private:
  SharedComputed find(const std::string& key, const Prepared& prepared);
  /// Waits while another computes it; null when nobody does any more.
  SharedComputed wait_for_another(const std::string& key, const Prepared& prepared, std::chrono::milliseconds time,
                                  const Job& job);

  const Engine& engine_;
  queue::ResultStore store_;
};

}  // namespace dini::jobs
