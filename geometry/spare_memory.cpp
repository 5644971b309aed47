#include "geometry/spare_memory.h"

#include <algorithm>

namespace dini {

void* SpareMemory::take(std::size_t size) noexcept {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = count_; i-- > 0;) {
    if (pieces_[i].size != size) continue;
    void* const memory = pieces_[i].memory;
    std::copy(pieces_.begin() + i + 1, pieces_.begin() + count_, pieces_.begin() + i);
    --count_;
    bytes_ -= size;
    return memory;
  }
  return nullptr;
}

void SpareMemory::keep(void* memory, std::size_t size) noexcept {
  Pieces oldest;
  std::size_t count = 0;
  {
    const std::lock_guard lock(mutex_);
    if (size <= limit_) {
      count = take_oldest(limit_ - size, oldest);
      pieces_[count_++] = {memory, size};
      bytes_ += size;
      memory = nullptr;
    }
  }
  unmap(oldest, count);
  if (memory != nullptr) unmap_(memory, size);
}

std::size_t SpareMemory::give_back() noexcept {
  Pieces oldest;
  std::size_t count = 0, bytes = 0;
  {
    const std::lock_guard lock(mutex_);
    bytes = bytes_;
    count = take_oldest(0, oldest);
  }
  unmap(oldest, count);
  return bytes;
}

void SpareMemory::limit(std::size_t bytes) noexcept {
  Pieces oldest;
  std::size_t count = 0;
  {
    const std::lock_guard lock(mutex_);
    limit_ = bytes;
    count = take_oldest(bytes, oldest);
  }
  unmap(oldest, count);
}

std::size_t SpareMemory::bytes() const noexcept {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

std::size_t SpareMemory::take_oldest(std::size_t bytes, Pieces& oldest) noexcept {
  std::size_t count = 0;
  while (count < count_ && (bytes_ > bytes || count_ - count == most_pieces)) {
    oldest[count] = pieces_[count];
    bytes_ -= pieces_[count].size;
    ++count;
  }
  std::copy(pieces_.begin() + count, pieces_.begin() + count_, pieces_.begin());
  count_ -= count;
  return count;
}

void SpareMemory::unmap(const Pieces& pieces, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) unmap_(pieces[i].memory, pieces[i].size);
}

}  // namespace dini
