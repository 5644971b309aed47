#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/hash_seed.h"

namespace dini {

/// Numbers keys of N whole numbers from 0 on, in the order in which they are first asked for. For keys out of files:
/// it takes at most 4 N + 16 bytes for each, and its order inside, which is seeded, never shows.
template <std::size_t N>
class KeyNumbers {
 public:
  using Key = std::array<std::uint32_t, N>;

  struct Found {
    std::uint32_t number = 0;
    bool fresh = false;  ///< the key was not there before
  };

  Found number_of(const Key& key) {
    if (2 * (keys_.size() + 1) > slots_.size()) grow();
    std::uint32_t& slot = slots_[slot_of(key)];
    if (slot != empty) return {slot, false};
    slot = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {slot, true};
  }

 private:
  static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

  /// Where the key stands, or would stand.
  std::size_t slot_of(const Key& key) const {
    std::uint64_t bits = hash_seed();
    for (const std::uint32_t part : key) bits = hash_with(bits, part);
    std::size_t slot = bits & (slots_.size() - 1);
    while (slots_[slot] != empty && keys_[slots_[slot]] != key) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), empty);
    for (std::uint32_t number = 0; number < keys_.size(); ++number) slots_[slot_of(keys_[number])] = number;
  }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> slots_;  ///< twice as many as keys at least, a power of two
};

}  // namespace dini
