#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "queue/link.h"

namespace dini::queue {

/// Results by a key of what they depend on, which all servers of a queue share. It is never needed: what is not there,
/// or not there as it was put, is computed, and whoever asks loses at most a tenth of a second to a Redis that is not
/// well, once. Safe to use from many threads.
class ResultStore {
 public:
  /// Larger results are not kept.
  static constexpr std::size_t most_bytes = std::size_t{8} << 20;

  /// `version` is that of the engine: results of others are not seen.
  ResultStore(Link& link, std::string version);

  /// Nothing when it is not there. What was damaged is taken out and counted.
  std::optional<std::string> find(const std::string& key);
  void keep(const std::string& key, const std::string& bytes);

  /// Whether nobody else computes it at this moment; then others are told for so long that somebody does. True also
  /// when that cannot be known.
  bool lease(const std::string& key, std::chrono::milliseconds time);
  /// Nobody computes it any more.
  void release(const std::string& key);

  struct Counts {
    std::atomic<std::size_t> hits = 0;
    std::atomic<std::size_t> misses = 0;
    std::atomic<std::size_t> damaged = 0;
    std::atomic<std::size_t> kept = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  /// What Redis answers; nothing when it is not well.
  std::optional<Reply> call(const std::vector<std::string>& words);
  std::optional<Reply> run(const Script& script, const std::vector<std::string>& arguments);
  template <class Ask>
  std::optional<Reply> ask(Ask ask);

  Link& link_;
  const std::string version_;
  const std::string owner_;  ///< of leases
  Counts counts_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Connection>> idle_;
};

}  // namespace dini::queue
