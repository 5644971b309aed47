#pragma once

#include <algorithm>
#include <cstddef>

#include "geometry/chunks.h"
#include "geometry/zeroed.h"

namespace dini {

/// Computes something for each of `count` items on all threads, and hands it on one after another in the order of the
/// items, so that sums of it never depend on the threads: take(i, compute(i)). Stopped early: some at the end are left
/// out.
template <class Result, class Compute, class Take>
void compute_in_order(const Cancel& cancel, std::size_t count, const Compute& compute, const Take& take) {
  constexpr std::size_t at_once = std::size_t{1} << 15, chunk = std::size_t{1} << 10;
  Zeroed<Result> results(std::min(count, at_once));
  for (std::size_t first = 0; first < count; first += at_once) {
    const std::size_t size = std::min(at_once, count - first);
    for_chunks(cancel, size, chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) results[i] = compute(first + i);
    });
    if (cancel.stopped()) return;
    for (std::size_t i = 0; i < size; ++i) take(first + i, results[i]);
  }
}

}  // namespace dini
