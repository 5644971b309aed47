#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dini {

/// "1 face is", "2 faces are": so many things in words that go with their number.
inline std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace dini
