#include "geometry/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace dini {

namespace {

using Linear = std::array<double, 3>;

constexpr std::array<Linear, 5> diverging = {{{0.010, 0.045, 0.260},
                                              {0.060, 0.280, 0.620},
                                              {0.760, 0.740, 0.680},
                                              {0.680, 0.160, 0.060},
                                              {0.260, 0.010, 0.025}}};
constexpr std::array<Linear, 5> sequential = {{{0.058, 0.0004, 0.090},
                                               {0.043, 0.085, 0.255},
                                               {0.014, 0.279, 0.263},
                                               {0.105, 0.580, 0.121},
                                               {0.984, 0.799, 0.019}}};
constexpr std::array<Linear, 7> cyclic = {{{0.720, 0.080, 0.060},
                                           {0.750, 0.390, 0.040},
                                           {0.220, 0.480, 0.070},
                                           {0.030, 0.440, 0.400},
                                           {0.050, 0.200, 0.640},
                                           {0.370, 0.090, 0.520},
                                           {0.720, 0.080, 0.060}}};

std::array<float, 4> between(std::span<const Linear> stops, double share) {
  const double place = share * static_cast<double>(stops.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double rest = place - static_cast<double>(index);
  std::array<float, 4> color = {0, 0, 0, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] = static_cast<float>((1 - rest) * stops[index][k] + rest * stops[index + 1][k]);
  }
  return color;
}

}  // namespace

std::array<float, 4> palette_color(Palette palette, double share) {
  if (!std::isfinite(share)) share = share > 0 ? 1 : 0;
  if (palette == Palette::cyclic) return between(cyclic, share - std::floor(share));
  return between(
      palette == Palette::diverging ? std::span<const Linear>(diverging) : std::span<const Linear>(sequential),
      std::clamp(share, 0.0, 1.0));
}

}  // namespace dini
