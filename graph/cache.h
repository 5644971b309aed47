#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "graph/context.h"
#include "graph/digest.h"
#include "graph/value.h"

namespace dini {

/// What a node made: one column per output, and what it had to say.
struct NodeResult {
  std::vector<AnyColumn> columns;
  std::vector<Warning> warnings;
};

/// Results by fingerprint under a byte budget; the least recently used go first. Safe to use from many threads.
/// Results larger than the whole budget are not kept.
class Cache {
 public:
  explicit Cache(std::size_t budget) : budget_(budget) {}

  /// The result, or null. Counts as a use.
  std::shared_ptr<const NodeResult> find(const Digest& fingerprint);
  void insert(const Digest& fingerprint, std::shared_ptr<const NodeResult> result);

  std::size_t bytes() const;
  std::size_t size() const;

 private:
  struct Entry {
    Digest fingerprint;
    std::shared_ptr<const NodeResult> result;
    std::size_t bytes;
  };

  const std::size_t budget_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  ///< most recently used first
  std::map<Digest, std::list<Entry>::iterator> index_;
  std::size_t bytes_ = 0;
};

}  // namespace dini
