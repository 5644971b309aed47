#pragma once

#include <cmath>

namespace dini::support {

/// The 8-bit value of a picture (sRGB, IEC 61966-2-1) that a linear share of light is shown as.
inline int picture_value(double linear) {
  const double stored = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255 * stored));
}

}  // namespace dini::support
