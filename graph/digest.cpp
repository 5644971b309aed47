#include "graph/digest.h"

#include <new>
#include <openssl/evp.h>

namespace dini {
namespace {

const EVP_MD* found_sha256() {
  const EVP_MD* const found = EVP_MD_fetch(nullptr, "SHA256", nullptr);
  if (found == nullptr) throw std::bad_alloc();
  return found;
}

}  // namespace

Digest sha256(std::string_view bytes) {
  // Looked up once: OpenSSL's one-shot function does it at each call, which takes as long as the digest of a node.
  // Where memory lacked for that, it is looked up again.
  static const EVP_MD* const algorithm = found_sha256();
  Digest digest;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, algorithm, nullptr) != 1) throw std::bad_alloc();
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
  char piece[9] = {'i'};
  for (int byte = 0; byte < 8; ++byte) piece[byte + 1] = static_cast<char>(value >> (8 * byte) & 255);
  bytes_.append(piece, sizeof piece);
  return *this;
}

DigestBuilder& DigestBuilder::digest(const Digest& value) {
  bytes_ += 'd';
  bytes_.append(value.begin(), value.end());
  return *this;
}

}  // namespace dini
