#include "geometry/place_text.h"

#include <array>
#include <charconv>

namespace dini {

std::string short_text(double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::general, 4);
  return {digits.data(), end.ptr};
}

std::string place_text(const Vector& place) {
  return "(" + short_text(place.x) + ", " + short_text(place.y) + ", " + short_text(place.z) + ")";
}

}  // namespace dini
