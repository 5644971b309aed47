#include "geometry/large_memory.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <new>
#include <sys/mman.h>

#include "geometry/spare_memory.h"

namespace dini {

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;
constexpr std::size_t usual_spare_memory = std::size_t{1} << 27;

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

void unmap_piece(void* memory, std::size_t size) noexcept {
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  unmap(begin, begin + size);
}

/// Never destroyed: arrays that are static may be freed after everything else.
SpareMemory& spare_memory() {
  static auto& spare = *new SpareMemory(usual_spare_memory, unmap_piece);
  return spare;
}

/// What is mapped for so many bytes: one of eight sizes between a power of two and the next, so that arrays of nearly
/// the same size use the same pieces. What is not touched of it never becomes memory.
std::size_t piece_size(std::size_t bytes) {
  const std::size_t step = std::bit_floor(bytes) / 8;
  const std::size_t size = rounded_up(bytes, step);
  if (size < bytes || size + huge_page < size) throw std::bad_alloc();
  return size;
}

struct Piece {
  void* memory;
  bool zero;
};

Piece get_piece(std::size_t size) {
  if (void* const spare = spare_memory().take(size)) return {spare, false};
  for (;;) {
    if (void* const memory = try_to_map(size)) return {memory, true};
    if (give_back_spare_memory()) continue;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

}  // namespace

bool is_large_memory(std::size_t bytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return bytes == ~std::size_t{0};  // sanitizers watch what malloc gives
#else
  return bytes >= huge_page;
#endif
}

void* get_large_memory(std::size_t bytes) { return get_piece(piece_size(bytes)).memory; }

void* get_zeroed_large_memory(std::size_t bytes) {
  const Piece piece = get_piece(piece_size(bytes));
  if (!piece.zero) std::memset(piece.memory, 0, bytes);
  return piece.memory;
}

void free_large_memory(void* memory, std::size_t bytes) noexcept { spare_memory().keep(memory, piece_size(bytes)); }

void limit_spare_memory(std::size_t bytes) noexcept { spare_memory().limit(bytes); }

bool give_back_spare_memory() noexcept { return spare_memory().give_back() > 0; }

}  // namespace dini
