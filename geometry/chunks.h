#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "geometry/cancel.h"

namespace dini {

/// Elements of a chunk whose work is some nanoseconds each.
inline constexpr std::size_t usual_chunk = 4096;

/// Runs `work(begin, end)` over 0 ... size on all threads, in chunks of at most `chunk` elements, and looks at the flag
/// before each. Which thread does what never shows in the result as long as a chunk writes its own elements only.
/// Stopped early: some chunks are left out.
template <class Work>
void for_chunks(const Cancel& cancel, std::size_t size, std::size_t chunk, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, chunk), [&](const auto& range) {
    for (std::size_t begin = range.begin(); begin < range.end(); begin += chunk) {
      if (cancel.stopped()) return;
      work(begin, std::min(begin + chunk, range.end()));
    }
  });
}

template <class Work>
void for_chunks(const Cancel& cancel, std::size_t size, const Work& work) {
  for_chunks(cancel, size, usual_chunk, work);
}

/// The smallest index below `size` of which `test` is true; it is asked on all threads. Stopped early: perhaps another
/// one, or none.
template <class Test>
std::optional<std::size_t> first_where(const Cancel& cancel, std::size_t size, const Test& test) {
  std::atomic<std::size_t> first = size;
  for_chunks(cancel, size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i >= first.load(std::memory_order_relaxed)) return;
      if (!test(i)) continue;
      std::size_t known = first;
      while (i < known && !first.compare_exchange_weak(known, i)) {
      }
      return;
    }
  });
  return first == size ? std::nullopt : std::optional<std::size_t>(first);
}

}  // namespace dini
