#include "server/known_requests.h"

#include <algorithm>

namespace dini::server {
namespace {

/// Enough for the graphs that are being worked on at one time; each entry is at most a few MiB.
constexpr std::size_t most_entries = 16;

}  // namespace

std::shared_ptr<const KnownRequest> KnownRequests::find(const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(entries_, bytes, &Entry::bytes);
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return found->request;
}

std::shared_ptr<const KnownRequest> KnownRequests::insert(const std::string& bytes, KnownRequest request) {
  auto known = std::make_shared<const KnownRequest>(std::move(request));
  const std::lock_guard lock(mutex_);
  entries_.push_front({bytes, known});
  if (entries_.size() > most_entries) entries_.pop_back();
  return known;
}

}  // namespace dini::server
