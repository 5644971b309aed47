#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <vector>

namespace dini {

/// Bytes of a Draco stream in the making: little-endian numbers, and variable-length ones with seven bits a byte,
/// lowest first (bitstream 2.2, "DecodeVarint").
class ByteWriter {
 public:
  void byte(std::uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  void number(std::int32_t value) { little_endian(static_cast<std::uint32_t>(value)); }
  void number(float value) { little_endian(std::bit_cast<std::uint32_t>(value)); }
  void text(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }

  void varint(std::unsigned_integral auto value) {
    for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
    byte(static_cast<std::uint8_t>(value));
  }

  /// A block that says its own size.
  void block(std::string_view content) {
    varint(content.size());
    text(content);
  }

  std::string_view view() const { return {bytes_.data(), bytes_.size()}; }
  std::vector<char> take() { return std::move(bytes_); }

 private:
  void little_endian(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
  }

  std::vector<char> bytes_;
};

}  // namespace dini
