#include "geometry/file_colors.h"

#include <algorithm>
#include <cmath>

#include "algebra/elementary.h"

namespace dini {

namespace {

constexpr float no_alpha = -1;

float linear_color(double stored) {
  if (!std::isfinite(stored)) return static_cast<float>(stored);
  const double share = std::clamp(stored, 0.0, 1.0);
  return static_cast<float>(share <= 0.04045 ? share / 12.92 : elementary::pow((share + 0.055) / 1.055, 2.4));
}

/// Told by the largest finite value among the channels from `first` to before `last`.
double full_value(const std::vector<std::array<float, 4>>& colors, std::size_t first, std::size_t last,
                  const FullValue& full) {
  float largest = 0;
  for (const auto& color : colors) {
    for (std::size_t k = first; k < last; ++k) {
      if (std::isfinite(color[k])) largest = std::max(largest, color[k]);
    }
  }
  return std::max(full.least, largest > 255 ? full.most : largest > 2 ? 255.0 : 1.0);
}

}  // namespace

std::array<float, 4> file_color(double red, double green, double blue, std::optional<double> alpha) {
  // A comparison with NaN is false, so that it stays.
  const auto channel = [](double value) { return value < 0 ? 0.0f : static_cast<float>(value); };
  return {channel(red), channel(green), channel(blue), alpha ? channel(*alpha) : no_alpha};
}

double picture_share(double linear) {
  if (!(linear > 0)) return 0;
  const double light = std::min(linear, 1.0);
  return light <= 0.0031308 ? 12.92 * light : 1.055 * elementary::pow(light, 1 / 2.4) - 0.055;
}

void make_linear(std::vector<std::array<float, 4>>& colors, const FullValue& light, const FullValue& alpha) {
  const double bright = full_value(colors, 0, 3, light), opaque = full_value(colors, 3, 4, alpha);
  for (auto& color : colors) {
    if (color == no_file_color) {
      color = {1, 1, 1, 1};
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) color[k] = linear_color(static_cast<double>(color[k]) / bright);
    color[3] = color[3] == no_alpha ? 1 : static_cast<float>(static_cast<double>(color[3]) / opaque);
  }
}

}  // namespace dini
