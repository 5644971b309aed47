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
