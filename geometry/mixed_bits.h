#pragma once

#include <cstdint>

namespace dini {

/// What SplitMix64 adds from one number of its stream to the next (Steele, Lea, Flood, "Fast splittable pseudorandom
/// number generators", 2014).
inline constexpr std::uint64_t splitmix_step = 0x9E3779B97F4A7C15u;

/// The last part of SplitMix64: each bit depends on all of them, and no two numbers give the same.
inline std::uint64_t mixed_bits(std::uint64_t bits) {
  bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ bits >> 27) * 0x94D049BB133111EBu;
  return bits ^ bits >> 31;
}

}  // namespace dini
