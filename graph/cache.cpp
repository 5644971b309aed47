#include "graph/cache.h"

namespace dini {

std::shared_ptr<const void> Cache::find_any(const Digest& digest) {
  const std::lock_guard lock(mutex_);
  const auto found = index_.find(digest);
  if (found == index_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->thing;
}

void Cache::insert_any(const Digest& digest, std::shared_ptr<const void> thing, std::size_t bytes) {
  constexpr std::size_t overhead = 256;  // the entry itself, its index node and the shared headers
  bytes += overhead;
  if (bytes > budget_) return;
  // Everything that may run out of memory comes before anything is changed.
  std::list<Entry> fresh;
  fresh.push_back({digest, std::move(thing), bytes});
  std::list<Entry> evicted;  // large things take long to free, so they go when others may come in again
  const std::lock_guard lock(mutex_);
  if (!index_.emplace(digest, fresh.begin()).second) return;
  entries_.splice(entries_.begin(), fresh);
  bytes_ += bytes;
  while (bytes_ > budget_) {
    bytes_ -= entries_.back().bytes;
    index_.erase(entries_.back().digest);
    evicted.splice(evicted.begin(), entries_, std::prev(entries_.end()));
    ++evictions_;
  }
}

bool Cache::contains(const Digest& digest) const {
  const std::lock_guard lock(mutex_);
  return index_.contains(digest);
}

void Cache::clear() {
  std::list<Entry> gone;  // freed when others may come in again
  const std::lock_guard lock(mutex_);
  index_.clear();
  gone.swap(entries_);
  bytes_ = 0;
}

std::size_t Cache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

std::size_t Cache::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

std::size_t Cache::evictions() const {
  const std::lock_guard lock(mutex_);
  return evictions_;
}

}  // namespace dini
