#include "gltf/base64.h"

#include <algorithm>
#include <openssl/evp.h>

namespace dini {

std::string to_base64(std::string_view bytes) {
  // The library counts in int and ends each piece with a zero; whole triples join without padding.
  constexpr std::size_t piece = std::size_t{3} << 20;
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  char* end = text.data();
  for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
    const std::string_view some = bytes.substr(begin, piece);
    end += EVP_EncodeBlock(reinterpret_cast<unsigned char*>(end), reinterpret_cast<const unsigned char*>(some.data()),
                           static_cast<int>(some.size()));
  }
  text.pop_back();
  return text;
}

}  // namespace dini
