#include "geometry/weld.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "geometry/chunks.h"
#include "geometry/hash_seed.h"

namespace dini {

namespace {

std::uint64_t mixed(std::uint64_t bits) {
  bits ^= bits >> 32;
  bits *= 0xd6e8feb86659fd93u;
  bits ^= bits >> 32;
  bits *= 0xd6e8feb86659fd93u;
  return bits ^ (bits >> 32);
}

std::uint64_t hash_of(const Point& p, std::uint64_t seed) {
  // Adding zero turns -0 into 0, which must have the same hash.
  return mixed(std::bit_cast<std::uint64_t>(p.x + 0.0) +
               mixed(std::bit_cast<std::uint64_t>(p.y + 0.0) + mixed(std::bit_cast<std::uint64_t>(p.z + 0.0) + seed)));
}

}  // namespace

std::vector<std::uint32_t> position_labels(const Column<Point>& positions, const Cancel& cancel) {
  const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
  Zeroed<std::uint32_t> table(mask + 1);  // one more than the index, so that 0 is free
  std::vector<std::uint32_t> labels(positions.size());
  const std::uint64_t seed = hash_seed();
  // A slot that is taken keeps its position and only ever gets smaller indices of the same, whoever comes first.
  for_chunks(cancel, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point point = positions[i];
      const auto own = static_cast<std::uint32_t>(i + 1);
      std::size_t slot = hash_of(point, seed) & mask;
      for (;; slot = (slot + 1) & mask) {
        std::atomic_ref taken(table[slot]);
        std::uint32_t known = taken.load(std::memory_order_relaxed);
        if (known == 0 && taken.compare_exchange_strong(known, own, std::memory_order_relaxed)) break;
        if (positions[known - 1] != point) continue;
        while (own < known && !taken.compare_exchange_weak(known, own, std::memory_order_relaxed)) {
        }
        break;
      }
      labels[i] = static_cast<std::uint32_t>(slot);
    }
  });
  for_chunks(cancel, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) labels[i] = table[labels[i]] - 1;
  });
  if (cancel.stopped()) std::fill(labels.begin(), labels.end(), 0u);
  return labels;
}

}  // namespace dini
