#pragma once

#include <atomic>

namespace dini {

/// Lowers a number that several threads lower.
template <class Number>
void lower_to(std::atomic<Number>& number, Number to) {
  Number known = number;
  while (to < known && !number.compare_exchange_weak(known, to)) {
  }
}

/// Raises a number that several threads raise.
template <class Number>
void raise_to(std::atomic<Number>& number, Number to) {
  Number known = number;
  while (to > known && !number.compare_exchange_weak(known, to)) {
  }
}

}  // namespace dini
