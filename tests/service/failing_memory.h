#pragma once

// Memory that runs out when a test wants it to: replaces operator new of the whole program.

#include <atomic>

namespace dini::support {

/// How many allocations succeed from now on before one fails; negative for all. Counts those of all threads.
extern std::atomic<long> allocations_left;

/// Allocations that have not been freed.
extern std::atomic<long> live_allocations;

}  // namespace dini::support
