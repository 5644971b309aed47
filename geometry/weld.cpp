#include "geometry/weld.h"

#include <bit>

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
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < positions.size() && !steps.stopped(); ++i) {
    const Point point = positions[i];
    std::size_t slot = hash_of(point, seed) & mask;
    while (table[slot] != 0 && positions[table[slot] - 1] != point) slot = (slot + 1) & mask;
    if (table[slot] == 0) table[slot] = static_cast<std::uint32_t>(i + 1);
    labels[i] = table[slot] - 1;
  }
  return labels;
}

}  // namespace dini
