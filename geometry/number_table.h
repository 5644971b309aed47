#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "geometry/cancel.h"
#include "geometry/hash_seed.h"
#include "geometry/zeroed.h"

namespace dini {

/// Numbers by keys, only ever added and looked up. In one piece of memory, so that it is thrown away at once, and the
/// flag is looked at while it grows. Seeded, since keys may come from a file.
class NumberTable {
 public:
  NumberTable() : slots_(std::size_t{1} << smallest) {}

  /// The number of `key`; `fresh` becomes its number when there was none, which shows in the second.
  std::pair<std::uint32_t&, bool> try_emplace(std::uint64_t key, std::uint32_t fresh, const Cancel& cancel) {
    if (2 * (used_ + 1) > slots_.size()) grow(cancel);
    Slot& slot = slots_[place_of(key)];
    if (slot.taken) return {slot.number, false};
    slot = {key, fresh, true};
    ++used_;
    return {slot.number, true};
  }

 private:
  struct Slot {
    std::uint64_t key;
    std::uint32_t number;
    bool taken;
  };
  static constexpr std::size_t smallest = 6;  ///< power of two

  std::size_t place_of(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = hash_with(hash_seed(), key) & mask;
    while (slots_[place].taken && slots_[place].key != key) place = (place + 1) & mask;
    return place;
  }

  void grow(const Cancel& cancel) {
    Zeroed<Slot> old(2 * slots_.size());
    std::swap(old, slots_);
    CancelEvery steps(cancel);
    for (std::size_t i = 0; i < old.size() && !steps.stopped(); ++i) {
      if (old[i].taken) slots_[place_of(old[i].key)] = old[i];
    }
  }

  Zeroed<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace dini
