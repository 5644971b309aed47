#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace dini {

/// A SHA-256.
using Digest = std::array<std::uint8_t, 32>;

/// For hashed containers: a digest is as good a hash as there is.
struct DigestHash {
  std::size_t operator()(const Digest& digest) const {
    std::size_t hash = 0;
    std::memcpy(&hash, digest.data(), sizeof hash);
    return hash;
  }
};

Digest sha256(std::string_view bytes);
std::string to_hex(const Digest& digest);
/// What `to_hex` wrote; nothing for any other text.
std::optional<Digest> digest_from_hex(std::string_view text);

/// Gathers what a digest depends on. Every piece is written with its kind and length, so different contents never meet.
class DigestBuilder {
 public:
  DigestBuilder& text(std::string_view value);
  DigestBuilder& integer(std::uint64_t value);
  DigestBuilder& number(double value) { return integer(std::bit_cast<std::uint64_t>(value)); }
  DigestBuilder& digest(const Digest& value);

  Digest finish() const { return sha256(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace dini
