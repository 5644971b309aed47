#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dini {

/// Calls visit(number, frequency) for each number that occurs, in their order; `frequencies` has one for each number.
/// Tables of small tiles are wide and nearly empty.
template <class Visit>
void for_each_that_occurs(std::span<const std::uint32_t> frequencies, const Visit& visit) {
  constexpr std::size_t together = 8;
  std::size_t i = 0;
  for (; i + together <= frequencies.size(); i += together) {
    std::uint32_t any = 0;
    for (std::size_t k = 0; k < together; ++k) any |= frequencies[i + k];
    if (any == 0) continue;
    for (std::size_t k = 0; k < together; ++k) {
      if (frequencies[i + k] > 0) visit(i + k, frequencies[i + k]);
    }
  }
  for (; i < frequencies.size(); ++i) {
    if (frequencies[i] > 0) visit(i, frequencies[i]);
  }
}

}  // namespace dini
