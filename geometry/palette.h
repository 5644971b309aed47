#pragma once

#include <array>

namespace dini {

/// How numbers are shown as colors.
enum class Palette {
  diverging,   ///< blue below the middle, pale at it, red above
  sequential,  ///< dark violet over green to yellow
  cyclic,      ///< all hues, the end equal to the start
};

/// The color at `share` of the range, linear and opaque; shares outside 0 to 1 are taken as the nearer end, or, on the
/// cyclic palette, go around.
std::array<float, 4> palette_color(Palette palette, double share);

}  // namespace dini
