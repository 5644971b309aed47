#include <cstdint>
#include <hwy/nanobenchmark.h>

// When libhwy is loaded it measures for two milliseconds how exact the clock of the processor is, for its benchmarks,
// which this program has none of. A function of the program goes before one of a library, also for the library itself;
// this one answers at once.

namespace hwy::platform {

std::uint64_t TimerResolution() { return 1; }

}  // namespace hwy::platform
