#include "jobs/process_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <string>
#include <unistd.h>

#include "geometry/large_memory.h"

namespace dini::jobs {
namespace {

std::size_t physical_bytes() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// The least limit of a group and those around it; `least` where none has one. What a container does not see of its
/// path is passed over.
std::size_t least_limit(std::filesystem::path group, const std::filesystem::path& top, const char* file,
                        std::size_t least) {
  for (;; group = group.parent_path()) {
    std::ifstream text(group / file);
    std::size_t limit = 0;
    if (text >> limit) least = std::min(least, limit);  // "max" is no number
    if (group == top || group == group.parent_path()) return least;
  }
}

}  // namespace

void use_few_memory_pools() {
  constexpr int pools = 2;
  mallopt(M_ARENA_MAX, pools);
}

void keep_spare_memory(std::size_t bytes) {
  limit_spare_memory(bytes);
  if (bytes == 0) return;
  // The pool of the small arrays likewise: it would shrink, and grow again page by page, with every evaluation.
  constexpr int largest_of_pool = 1 << 25;  // the most that malloc takes for this
  mallopt(M_MMAP_THRESHOLD, largest_of_pool);
  mallopt(M_TRIM_THRESHOLD, static_cast<int>(std::min<std::size_t>(bytes, std::numeric_limits<int>::max())));
}

void give_back_free_memory() {
  give_back_spare_memory();
  malloc_trim(0);
}

std::size_t resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::size_t whole = 0, resident = 0;
  return pages >> whole >> resident ? resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

std::size_t available_bytes(const std::filesystem::path& groups, const std::filesystem::path& membership) {
  std::size_t least = physical_bytes();
  std::ifstream lines(membership);
  for (std::string line; std::getline(lines, line);) {
    // "0::/path" of version 2, "4:memory:/path" of version 1.
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::filesystem::path path = std::filesystem::path(line.substr(second + 1)).relative_path();
    if (controllers.empty()) {
      least = least_limit(groups / path, groups, "memory.max", least);
    } else if (controllers == "memory") {
      least = least_limit(groups / "memory" / path, groups / "memory", "memory.limit_in_bytes", least);
    }
  }
  return least;
}

}  // namespace dini::jobs
