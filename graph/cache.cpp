#include "graph/cache.h"

namespace dini {

std::shared_ptr<const NodeResult> Cache::find(const Digest& fingerprint) {
  const std::lock_guard lock(mutex_);
  const auto found = index_.find(fingerprint);
  if (found == index_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->result;
}

void Cache::insert(const Digest& fingerprint, std::shared_ptr<const NodeResult> result) {
  constexpr std::size_t overhead = 256;  // the entry itself, its index node and the shared headers
  std::size_t size = overhead;
  for (const AnyColumn& column : result->columns) size += dini::bytes(column);
  if (size > budget_) return;
  const std::lock_guard lock(mutex_);
  if (index_.contains(fingerprint)) return;
  entries_.push_front({fingerprint, std::move(result), size});
  index_.emplace(fingerprint, entries_.begin());
  bytes_ += size;
  while (bytes_ > budget_) {
    bytes_ -= entries_.back().bytes;
    index_.erase(entries_.back().fingerprint);
    entries_.pop_back();
  }
}

std::size_t Cache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

std::size_t Cache::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

}  // namespace dini
