#include "jobs/process_memory.h"

#include <malloc.h>

namespace dini::jobs {

void use_few_memory_pools() {
  constexpr int pools = 2;
  mallopt(M_ARENA_MAX, pools);
}

void give_back_free_memory() { malloc_trim(0); }

}  // namespace dini::jobs
