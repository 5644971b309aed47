#include "graph/cache.h"

#include <algorithm>

namespace dini {

namespace {

/// Of some entries the one that was not used for longest.
template <class Entries>
auto oldest(const Entries& entries) {
  return *std::min_element(entries.begin(), entries.end(),
                           [](const auto& one, const auto& other) { return one->used < other->used; });
}

}  // namespace

std::shared_ptr<const void> Cache::find_any(const Digest& digest) {
  const std::lock_guard lock(mutex_);
  const auto found = index_.find(digest);
  if (found == index_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  found->second->used = ++uses_;
  return found->second->thing;
}

void Cache::insert_any(const Digest& digest, std::shared_ptr<const void> thing, std::size_t bytes,
                       const std::optional<Digest>& place) {
  constexpr std::size_t overhead = 256;  // the entry itself, its index node and the shared headers
  const bool is_version = place && bytes >= large;
  bytes += overhead;
  if (bytes > budget_) return;
  // Everything that may run out of memory comes before anything is changed.
  Entries fresh;
  fresh.push_back({digest, std::move(thing), bytes, is_version ? place : std::nullopt, 0});
  Entries evicted;  // large things take long to free, so they go when others may come in again
  const std::lock_guard lock(mutex_);
  if (index_.contains(digest)) return;
  std::vector<Entries::iterator>* const versions = is_version ? &versions_[*place] : nullptr;
  if (versions != nullptr) versions->reserve(most_versions + 1);
  index_.emplace(digest, fresh.begin());
  if (versions != nullptr) versions->push_back(fresh.begin());
  fresh.front().used = ++uses_;
  entries_.splice(entries_.begin(), fresh);
  bytes_ += bytes;
  if (versions != nullptr && versions->size() > most_versions) evict(oldest(*versions), evicted);
  while (bytes_ > budget_) evict(std::prev(entries_.end()), evicted);
}

void Cache::evict(Entries::iterator entry, Entries& evicted) {
  if (entry->place) {
    const auto versions = versions_.find(*entry->place);
    std::erase(versions->second, entry);
    if (versions->second.empty()) versions_.erase(versions);
  }
  bytes_ -= entry->bytes;
  index_.erase(entry->digest);
  evicted.splice(evicted.begin(), entries_, entry);
  ++evictions_;
}

bool Cache::contains(const Digest& digest) const {
  const std::lock_guard lock(mutex_);
  return index_.contains(digest);
}

void Cache::clear() {
  Entries gone;  // freed when others may come in again
  const std::lock_guard lock(mutex_);
  index_.clear();
  versions_.clear();
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
