#pragma once

#include <cstddef>

namespace dini {

/// Whether a piece of memory is large enough to come from the system by itself.
bool is_large_memory(std::size_t bytes);

/// Memory for a large array, all zero, in huge pages where the system has them: what makes a million triangles then
/// meets a few dozen page faults instead of ten thousand. Calls the handler of failed allocations as `new` does, and
/// throws std::bad_alloc.
void* map_large_memory(std::size_t bytes);

/// Gives memory back to the system at once, so that nobody holds what is not used; `bytes` is what it was asked for.
void unmap_large_memory(void* memory, std::size_t bytes) noexcept;

}  // namespace dini
