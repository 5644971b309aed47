#pragma once

#include <cstdint>
#include <random>

namespace dini {

/// Another number in every process, for hash tables over what comes from outside: a file that is made to put everything
/// into one place of a table would take minutes. What a table with it gives must not depend on the order inside of it.
inline std::uint64_t hash_seed() {
  static const std::uint64_t seed = std::uint64_t{std::random_device()()} << 32 | std::random_device()();
  return seed;
}

/// The hash `bits` with one more number in it; the first is `hash_seed()`.
inline std::uint64_t hash_with(std::uint64_t bits, std::uint64_t number) {
  bits = (bits ^ number) * 0x9E3779B97F4A7C15u;
  return bits ^ bits >> 29;
}

}  // namespace dini
