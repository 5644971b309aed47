#include "jobs/random_id.h"

#include <random>

#include "graph/digest.h"

namespace dini::jobs {

std::string random_id() {
  std::random_device random;
  Digest digest{};
  for (std::uint8_t& byte : digest) byte = static_cast<std::uint8_t>(random());
  return to_hex(digest).substr(0, 32);
}

}  // namespace dini::jobs
