#pragma once

#include <cstddef>

namespace dini {

/// Whether a piece of memory is large enough to come from the system by itself.
bool is_large_memory(std::size_t bytes);

/// Memory for a large array, in huge pages where the system has them: what makes a million triangles then meets a few
/// dozen page faults instead of ten thousand. It may hold anything. Calls the handler of failed allocations as `new`
/// does, and throws std::bad_alloc.
void* get_large_memory(std::size_t bytes);

/// The same, all zero.
void* get_zeroed_large_memory(std::size_t bytes);

/// Ends the use of such memory; `bytes` is what was asked for. A part of what is freed waits to be used again.
void free_large_memory(void* memory, std::size_t bytes) noexcept;

/// How many bytes of freed large memory may wait to be used again in the whole process, which has one source of memory.
void limit_spare_memory(std::size_t bytes) noexcept;

/// Gives the memory that waits back to the system; whether there was any.
bool give_back_spare_memory() noexcept;

}  // namespace dini
