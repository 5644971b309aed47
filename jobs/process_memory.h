#pragma once

#include <cstddef>
#include <filesystem>

namespace dini::jobs {

/// Lets the threads of the process share few pools of memory, so that what one has freed serves the others. Before any
/// thread begins.
void use_few_memory_pools();

/// How much memory that was freed may be kept for the next evaluation, beside what is in use: so much of large arrays,
/// and so much of all else. `give_back_free_memory` ends it.
void keep_spare_memory(std::size_t bytes);

/// Gives memory that is free within the process back to the machine.
void give_back_free_memory();

/// Memory that the process holds now; 0 where the system does not tell.
std::size_t resident_bytes();

/// Memory that the process may hold at all: the machine's, or less where it runs in a container or a service with a
/// limit (control groups of either version). The paths are those of Linux.
std::size_t available_bytes(const std::filesystem::path& groups = "/sys/fs/cgroup",
                            const std::filesystem::path& membership = "/proc/self/cgroup");

}  // namespace dini::jobs
