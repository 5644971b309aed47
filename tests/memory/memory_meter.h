#pragma once

#include <cstddef>

namespace dini::support {

/// Starts to count anew what the program asks for, on all threads, by whichever way: `new`, `malloc`,
/// `calloc` and `mprotect`.
void restart_memory_meter();

/// The most bytes that were held at once since the restart, beyond those that were held then.
std::size_t most_memory();

}  // namespace dini::support
