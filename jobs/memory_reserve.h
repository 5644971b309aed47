#pragma once

#include <cstddef>

namespace dini::jobs {

/// Memory that is put aside while there is plenty, and given back when an allocation fails: so that the small things
/// that are needed to say so, and to go on, are still to be had. A library that cannot even store an exception would
/// end the program. There is one for the whole process, since there is one handler of failed allocations.
class MemoryReserve {
 public:
  /// Puts it aside for as long as this object lives.
  explicit MemoryReserve(std::size_t bytes);
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

  /// Puts it aside again if it was given back and can be had. Any thread.
  static void refill();
};

}  // namespace dini::jobs
