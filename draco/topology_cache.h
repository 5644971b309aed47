#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "draco/tile_topology.h"

namespace dini {

/// Topologies of tiles that were met before, the least recently used leaving first. While somebody drags a slider the
/// triangles of a surface stay as they are, so nearly every tile is found here. May be asked from several threads.
class TopologyCache {
 public:
  /// Holds at most `bytes` bytes; with 0 nothing is kept.
  explicit TopologyCache(std::size_t bytes) : limit_(bytes) {}

  /// `tile_topology` of these triangles; null when they are no manifold.
  std::shared_ptr<const TileTopology> topology(Triangles triangles, std::size_t vertices);

  void clear();

  /// Bytes that are held now.
  std::size_t size() const;

 private:
  using Entry = std::shared_ptr<const TileTopology>;
  struct Kept {
    std::uint64_t key = 0;
    Entry topology;
  };

  Entry find(std::uint64_t key, Triangles triangles);
  void keep(std::uint64_t key, Entry topology);

  mutable std::mutex mutex_;
  std::list<Kept> recent_;  ///< most recently used first
  std::unordered_map<std::uint64_t, std::list<Kept>::iterator> by_key_;
  std::size_t size_ = 0;
  std::size_t limit_;
};

}  // namespace dini
