#include "draco/topology_cache.h"

#include <cstring>

namespace dini {
namespace {

// A few triangles tell tiles apart well enough: what is found is compared as a whole.
std::uint64_t key_of(Triangles triangles, std::size_t vertices) {
  constexpr std::size_t samples = 61;
  std::uint64_t key = 0x9e3779b97f4a7c15 * (triangles.size() + 1) ^ vertices;
  const std::size_t stride = triangles.size() / samples + 1;
  for (std::size_t i = 0; i < triangles.size(); i += stride) {
    for (const std::uint32_t vertex : triangles[i]) {
      key = (key ^ vertex) * 0xff51afd7ed558ccd;
      key ^= key >> 29;
    }
  }
  return key;
}

bool same(Triangles a, Triangles b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace

std::shared_ptr<const TileTopology> TopologyCache::topology(Triangles triangles, std::size_t vertices) {
  const std::uint64_t key = key_of(triangles, vertices);
  if (Entry found = find(key, triangles)) return found;
  Entry made = tile_topology(triangles, vertices);
  if (made != nullptr) keep(key, made);
  return made;
}

TopologyCache::Entry TopologyCache::find(std::uint64_t key, Triangles triangles) {
  Entry found;
  {
    const std::lock_guard lock(mutex_);
    const auto place = by_key_.find(key);
    if (place == by_key_.end()) return nullptr;
    recent_.splice(recent_.begin(), recent_, place->second);
    found = place->second->topology;
  }
  return same(found->triangles, triangles) ? found : nullptr;
}

void TopologyCache::keep(std::uint64_t key, Entry topology) {
  if (topology->size() > limit_) return;
  const std::lock_guard lock(mutex_);
  const auto place = by_key_.find(key);
  if (place != by_key_.end()) {
    size_ -= place->second->topology->size();
    recent_.erase(place->second);
    by_key_.erase(place);
  }
  size_ += topology->size();
  recent_.push_front({key, std::move(topology)});
  by_key_.emplace(key, recent_.begin());
  while (size_ > limit_) {
    size_ -= recent_.back().topology->size();
    by_key_.erase(recent_.back().key);
    recent_.pop_back();
  }
}

void TopologyCache::clear() {
  const std::lock_guard lock(mutex_);
  by_key_.clear();
  recent_.clear();
  size_ = 0;
}

std::size_t TopologyCache::size() const {
  const std::lock_guard lock(mutex_);
  return size_;
}

}  // namespace dini
