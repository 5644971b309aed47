#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include "geometry/large_memory.h"

namespace dini {

/// A fixed number of elements that begin with all bits zero. Unlike those of a std::vector, the zeros of a large array
/// are not written: the system gives memory that is zero when it is first touched, so making one takes no time, and
/// kernels touch it in parallel. For elements without pointers, whose zero is all bits zero. Throws std::bad_alloc.
template <class T>
class Zeroed {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  Zeroed() = default;
  explicit Zeroed(std::size_t size) : size_(size), elements_(size == 0 ? nullptr : allocate(size)) {}
  /// Elements that may hold anything, where all of them are written before one is read: then memory that was used
  /// before need not be cleared.
  static Zeroed unwritten(std::size_t size) {
    if (!is_large_memory(size * sizeof(T))) return Zeroed(size);
    check(size);
    Zeroed result;
    result.elements_ = static_cast<T*>(get_large_memory(size * sizeof(T)));
    result.size_ = size;
    return result;
  }
  Zeroed(const Zeroed& other) : Zeroed(unwritten(other.size_)) {
    if (size_ > 0) std::memcpy(static_cast<void*>(data()), other.data(), size_ * sizeof(T));
  }
  Zeroed(Zeroed&& other) noexcept
      : size_(std::exchange(other.size_, 0)), elements_(std::exchange(other.elements_, nullptr)) {}
  Zeroed& operator=(Zeroed other) noexcept {
    std::swap(size_, other.size_);
    std::swap(elements_, other.elements_);
    return *this;
  }
  ~Zeroed() {
    if (is_large_memory(size_ * sizeof(T))) {
      free_large_memory(elements_, size_ * sizeof(T));
    } else {
      std::free(elements_);
    }
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return elements_; }
  const T* data() const { return elements_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t index) { return elements_[index]; }
  const T& operator[](std::size_t index) const { return elements_[index]; }

  friend bool operator==(const Zeroed& a, const Zeroed& b) {
    return std::equal(a.data(), a.data() + a.size_, b.data(), b.data() + b.size_);
  }

 private:
  static void check(std::size_t size) {
    if (size > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
  }

  static T* allocate(std::size_t size) {
    check(size);
    if (is_large_memory(size * sizeof(T))) return static_cast<T*>(get_zeroed_large_memory(size * sizeof(T)));
    void* elements = std::calloc(size, sizeof(T));
    if (elements == nullptr) throw std::bad_alloc();
    return static_cast<T*>(elements);
  }

  std::size_t size_ = 0;
  T* elements_ = nullptr;
};

}  // namespace dini
