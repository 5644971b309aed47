#include "tests/memory/memory_meter.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define DINI_SANITIZER_ALLOCATES
#endif

namespace {

// Constant initialization: memory is asked for before anything else is initialized.
std::atomic<std::int64_t> held = 0;
std::atomic<std::int64_t> most = 0;
std::atomic<std::int64_t> held_at_restart = 0;

void add(std::size_t bytes) {
  const auto size = static_cast<std::int64_t>(bytes);
  const std::int64_t now = held.fetch_add(size, std::memory_order_relaxed) + size;
  std::int64_t known = most.load(std::memory_order_relaxed);
  while (known < now && !most.compare_exchange_weak(known, now, std::memory_order_relaxed)) {
  }
}

void take_away(std::size_t bytes) { held.fetch_sub(static_cast<std::int64_t>(bytes), std::memory_order_relaxed); }

}  // namespace

#ifdef DINI_SANITIZER_ALLOCATES

// Declared here: the header with these two comes with clang only, the library of g++ has them as well.
extern "C" {

std::size_t __sanitizer_get_allocated_size(const volatile void* memory);
int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void*, std::size_t),
                                              void (*released)(const volatile void*));

}  // extern "C"

namespace {

void on_allocation(const volatile void*, std::size_t bytes) { add(bytes); }

void on_release(const volatile void* memory) {
  if (memory != nullptr) take_away(__sanitizer_get_allocated_size(memory));
}

const int installed = __sanitizer_install_malloc_and_free_hooks(on_allocation, on_release);

}  // namespace

#else

namespace {

// Where large arrays are.
std::array<std::atomic<void*>, 1024> arrays = {};

bool replace(void* one, void* other) {
  for (std::atomic<void*>& place : arrays) {
    void* expected = one;
    if (place.compare_exchange_strong(expected, other)) return true;
  }
  return false;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept {
  void* memory = __libc_malloc(size);
  add(malloc_usable_size(memory));
  return memory;
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  void* memory = __libc_calloc(count, size);
  add(malloc_usable_size(memory));
  return memory;
}

void* realloc(void* old, std::size_t size) noexcept {
  take_away(malloc_usable_size(old));
  void* memory = __libc_realloc(old, size);
  add(malloc_usable_size(memory));
  return memory;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  void* memory = __libc_memalign(alignment, size);
  add(malloc_usable_size(memory));
  return memory;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

void free(void* memory) noexcept {
  take_away(malloc_usable_size(memory));
  __libc_free(memory);
}

// Large arrays are addresses that become memory and are unmapped as a whole. What malloc maps does not pass here.
int mprotect(void* memory, std::size_t size, int protection) noexcept {
  const auto result = static_cast<int>(syscall(SYS_mprotect, memory, size, protection));
  if (result == 0 && (protection & PROT_WRITE) != 0 && replace(nullptr, memory)) add(size);
  return result;
}

int munmap(void* memory, std::size_t size) noexcept {
  if (replace(memory, nullptr)) take_away(size);
  return static_cast<int>(syscall(SYS_munmap, memory, size));
}

}  // extern "C"

#endif

namespace dini::support {

void restart_memory_meter() {
  held_at_restart = held.load();
  most = held.load();
}

std::size_t most_memory() { return static_cast<std::size_t>(most - held_at_restart); }

}  // namespace dini::support
