#include "graph/digest.h"

#include <openssl/sha.h>

namespace dini {

Digest sha256(std::string_view bytes) {
  Digest digest;
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  return digest;
}

std::string to_hex(const Digest& digest) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::optional<Digest> digest_from_hex(std::string_view text) {
  Digest digest{};
  if (text.size() != 2 * digest.size()) return std::nullopt;
  constexpr std::string_view digits = "0123456789abcdef";
  for (std::size_t i = 0; i < digest.size(); ++i) {
    const auto high = digits.find(text[2 * i]), low = digits.find(text[2 * i + 1]);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    digest[i] = static_cast<std::uint8_t>(high << 4 | low);
  }
  return digest;
}

DigestBuilder& DigestBuilder::text(std::string_view value) {
  integer(value.size());
  bytes_ += 't';
  bytes_ += value;
  return *this;
}

DigestBuilder& DigestBuilder::integer(std::uint64_t value) {
  bytes_ += 'i';
  for (int shift = 0; shift < 64; shift += 8) bytes_ += static_cast<char>(value >> shift & 255);
  return *this;
}

DigestBuilder& DigestBuilder::digest(const Digest& value) {
  bytes_ += 'd';
  bytes_.append(value.begin(), value.end());
  return *this;
}

}  // namespace dini
