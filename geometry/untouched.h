#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/large_memory.h"

namespace dini {

/// An allocator whose vectors do not write elements that they are asked to have without a value: large ones are then
/// touched once, by the threads that fill them.
template <class T>
struct Untouched : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);

  Untouched() = default;
  template <class Other>
  explicit Untouched(const Untouched<Other>&) {}

  template <class Other>
  struct rebind {
    using other = Untouched<Other>;
  };

  T* allocate(std::size_t size) {
    if (size > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    if (!is_large_memory(size * sizeof(T))) return std::allocator<T>::allocate(size);
    return static_cast<T*>(get_large_memory(size * sizeof(T)));
  }
  void deallocate(T* items, std::size_t size) {
    if (!is_large_memory(size * sizeof(T))) return std::allocator<T>::deallocate(items, size);
    free_large_memory(items, size * sizeof(T));
  }

  template <class Element>
  void construct(Element* place) noexcept {
    ::new (static_cast<void*>(place)) Element;
  }
  template <class Element, class... Arguments>
  void construct(Element* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) Element(std::forward<Arguments>(arguments)...);
  }
};

/// A vector of numbers or small arrays of them. Elements that `resize` adds without a value have none until they are
/// written.
template <class T>
using NumberList = std::vector<T, Untouched<T>>;

}  // namespace dini
