#include "jobs/process_memory.h"

#include <fstream>
#include <malloc.h>
#include <unistd.h>

namespace dini::jobs {

void use_few_memory_pools() {
  constexpr int pools = 2;
  mallopt(M_ARENA_MAX, pools);
}

void give_back_free_memory() { malloc_trim(0); }

std::size_t resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::size_t whole = 0, resident = 0;
  return pages >> whole >> resident ? resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace dini::jobs
