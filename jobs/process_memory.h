#pragma once

#include <cstddef>

namespace dini::jobs {

/// Lets the threads of the process share few pools of memory, so that what one has freed serves the others. Before any
/// thread begins.
void use_few_memory_pools();

/// Gives memory that is free within the process back to the machine.
void give_back_free_memory();

/// Memory that the process holds now; 0 where the system does not tell.
std::size_t resident_bytes();

}  // namespace dini::jobs
