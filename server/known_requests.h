#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "service/engine.h"

namespace dini::server {

/// A request that was read and checked.
struct KnownRequest {
  std::shared_ptr<const Prepared> prepared;
  std::string output;
  std::optional<std::int64_t> deadline_milliseconds;
};

/// The most recent requests by their exact bytes: reading and checking an unchanged large graph would take many times
/// longer than finding its result in the cache. Safe to use from many threads.
class KnownRequests {
 public:
  std::shared_ptr<const KnownRequest> find(const std::string& bytes);
  std::shared_ptr<const KnownRequest> insert(const std::string& bytes, KnownRequest request);

 private:
  struct Entry {
    std::string bytes;
    std::shared_ptr<const KnownRequest> request;
  };

  std::mutex mutex_;
  std::list<Entry> entries_;  ///< most recently used first
};

}  // namespace dini::server
