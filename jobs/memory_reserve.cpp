#include "jobs/memory_reserve.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "geometry/large_memory.h"

namespace dini::jobs {
namespace {

/// What the handler of failed allocations can reach: it takes no argument.
std::atomic<void*> reserve = nullptr;
std::atomic<std::size_t> reserve_bytes = 0;
std::new_handler earlier_handler = nullptr;

/// Lets the allocation be tried once more when there was something to give back.
void give_back() {
  if (give_back_spare_memory()) return;
  void* memory = reserve.exchange(nullptr);
  if (memory == nullptr) throw std::bad_alloc();
  std::free(memory);
}

}  // namespace

MemoryReserve::MemoryReserve(std::size_t bytes) {
  reserve_bytes = bytes;
  refill();
  earlier_handler = std::set_new_handler(give_back);
}

MemoryReserve::~MemoryReserve() {
  std::set_new_handler(earlier_handler);
  reserve_bytes = 0;
  std::free(reserve.exchange(nullptr));
}

void MemoryReserve::refill() {
  if (reserve_bytes == 0 || reserve != nullptr) return;
  void* memory = std::malloc(reserve_bytes);
  void* none = nullptr;
  if (!reserve.compare_exchange_strong(none, memory)) std::free(memory);
}

}  // namespace dini::jobs
