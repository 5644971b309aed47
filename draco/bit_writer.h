#pragma once

#include <cstdint>
#include <string>

namespace dini {

/// Bits one after another, the lowest of each value first, in bytes that are filled from their lowest bit.
class BitWriter {
 public:
  /// Adds the lowest `count` bits of `value`; `count` in 0..32.
  void bits(std::uint32_t value, int count) {
    pending_ |= (value & ((std::uint64_t{1} << count) - 1)) << pending_bits_;
    pending_bits_ += count;
    for (; pending_bits_ >= 8; pending_bits_ -= 8, pending_ >>= 8) bytes_.push_back(static_cast<char>(pending_ & 0xff));
  }

  /// The bytes so far, the last filled up with zeros. Nothing can be added afterwards.
  std::string take() {
    if (pending_bits_ > 0) bytes_.push_back(static_cast<char>(pending_ & 0xff));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t pending_ = 0;
  int pending_bits_ = 0;
};

}  // namespace dini
