#pragma once

#include <cstdint>

#include "geometry/cancel.h"

namespace dini::support {

/// How much the program has computed since it started, on all threads: basic blocks of its own layers, which the
/// compiler makes count themselves (DINI_COUNT_WORK). Some thousand may be missing.
std::uint64_t work_done();

/// Stops `cancel` once so much more has been computed, from whichever thread comes to it. It must outlive the work.
void stop_after(const Cancel& cancel, std::uint64_t work);

/// What had been computed when the flag was stopped; 0 when it was not.
std::uint64_t work_at_stop();

}  // namespace dini::support
