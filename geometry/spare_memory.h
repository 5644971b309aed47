#pragma once

#include <array>
#include <cstddef>
#include <mutex>

namespace dini {

/// Pieces of large memory that were freed and wait to be used again. Memory that is new to the process has to be
/// cleared by the system page by page, which takes longer than what is computed in it: while somebody drags a slider
/// the pieces of one model serve the next. Safe to use from many threads.
class SpareMemory {
 public:
  using Unmap = void (*)(void* memory, std::size_t size) noexcept;

  /// `unmap_piece` returns one to the system.
  explicit SpareMemory(std::size_t limit, Unmap unmap_piece) : limit_(limit), unmap_(unmap_piece) {}

  /// A piece of exactly this size that was kept, the last one first; null when there is none. It holds what was written
  /// into it before.
  void* take(std::size_t size) noexcept;

  /// Keeps a piece. What is more than the limit goes back to the system, the oldest first.
  void keep(void* memory, std::size_t size) noexcept;

  /// Gives everything back to the system; how many bytes it was.
  std::size_t give_back() noexcept;

  /// How many bytes may wait.
  void limit(std::size_t bytes) noexcept;

  std::size_t bytes() const noexcept;

 private:
  struct Piece {
    void* memory = nullptr;
    std::size_t size = 0;
  };
  static constexpr std::size_t most_pieces = 128;
  using Pieces = std::array<Piece, most_pieces>;

  /// Takes the oldest pieces out until at most `bytes` and one place less than all are left; how many they are.
  std::size_t take_oldest(std::size_t bytes, Pieces& oldest) noexcept;
  void unmap(const Pieces& pieces, std::size_t count) noexcept;

  mutable std::mutex mutex_;
  Pieces pieces_;  ///< the oldest first
  std::size_t count_ = 0;
  std::size_t bytes_ = 0;
  std::size_t limit_;
  const Unmap unmap_;
};

}  // namespace dini
