#include "geometry/large_memory.h"

#include <cstdint>
#include <new>
#include <sys/mman.h>

namespace dini {

namespace {

constexpr std::size_t page = 4096;
constexpr std::size_t huge_page = std::size_t{1} << 21;

constexpr std::uintptr_t rounded_up(std::uintptr_t number, std::size_t step) {
  return (number + step - 1) / step * step;
}

void unmap(std::uintptr_t begin, std::uintptr_t end) noexcept {
  if (end > begin) munmap(reinterpret_cast<void*>(begin), end - begin);
}

/// Memory that begins where a huge page can; null when there is none. Of the addresses that are asked for to find such
/// a place only those that are kept become memory.
void* try_to_map(std::size_t size) noexcept {
  const std::size_t reserved = size + huge_page;
  void* const mapped = mmap(nullptr, reserved, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapped == MAP_FAILED) return nullptr;
  const auto begin = reinterpret_cast<std::uintptr_t>(mapped);
  const std::uintptr_t aligned = rounded_up(begin, huge_page);
  unmap(begin, aligned);
  unmap(aligned + size, begin + reserved);
  void* const memory = reinterpret_cast<void*>(aligned);
  if (mprotect(memory, size, PROT_READ | PROT_WRITE) != 0) {
    unmap(aligned, aligned + size);
    return nullptr;
  }
  madvise(memory, size, MADV_HUGEPAGE);  // a wish: where it is not granted all is right, and slower
  return memory;
}

}  // namespace

bool is_large_memory(std::size_t bytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return bytes == ~std::size_t{0};  // sanitizers watch what malloc gives
#else
  return bytes >= huge_page;
#endif
}

void* map_large_memory(std::size_t bytes) {
  const std::size_t size = rounded_up(bytes, page);
  if (size < bytes || size + huge_page < size) throw std::bad_alloc();
  for (;;) {
    void* const memory = try_to_map(size);
    if (memory != nullptr) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void unmap_large_memory(void* memory, std::size_t bytes) noexcept {
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  unmap(begin, begin + rounded_up(bytes, page));
}

}  // namespace dini
