#include "geometry/noise.h"

#include <array>
#include <cmath>

#include "geometry/mixed_bits.h"

namespace dini {

namespace {

/// Farther out a cell is not much larger than the spacing of doubles.
constexpr double farthest_cell = 1e12;

/// One over the largest sum that corners can give (0.0130072, found by search), a little less: values stay in [-1, 1].
constexpr double noise_scale = 76.8;

/// A corner of a cell by its integer coordinates.
struct Lattice {
  std::int64_t x, y, z;
};

std::uint64_t hash_of(const Lattice& at, std::uint64_t seed) {
  std::uint64_t bits = seed + splitmix_step;
  for (const std::int64_t number : {at.x, at.y, at.z}) {
    bits = mixed_bits(bits ^ static_cast<std::uint64_t>(number) * 0xD6E8FEB86659FD93u);
  }
  return bits;
}

/// The product of `offset` with one of twelve directions, to the middles of the edges of a cube.
double slope_along(std::uint64_t hash, const Vector& offset) {
  const auto direction = static_cast<unsigned>((hash >> 32) * 12 >> 32);
  const double first = direction < 8 ? offset.x : offset.y;
  const double second = direction < 4 ? offset.y : offset.z;
  return ((direction & 1) != 0 ? -first : first) + ((direction & 2) != 0 ? -second : second);
}

/// What a corner adds at an offset from it.
double part_of(const Lattice& at, const Vector& offset, std::uint64_t seed) {
  const double left = 0.5 - squared_length(offset);
  if (!(left > 0)) return 0;
  const double square = left * left;
  return square * square * slope_along(hash_of(at, seed), offset);
}

}  // namespace

double simplex_noise(const Vector& place, std::uint64_t seed) {
  const double skew = (place.x + place.y + place.z) / 3;
  const Vector cell{std::floor(place.x + skew), std::floor(place.y + skew), std::floor(place.z + skew)};
  if (!(std::abs(cell.x) < farthest_cell && std::abs(cell.y) < farthest_cell && std::abs(cell.z) < farthest_cell)) {
    return 0;
  }
  const double back = (cell.x + cell.y + cell.z) / 6;
  const Vector first = place - cell + Vector{back, back, back};
  // The simplex goes along the axes in the order of the coordinates within the cell.
  const bool xy = first.x >= first.y, yz = first.y >= first.z, xz = first.x >= first.z;
  const Lattice one{xy && xz ? 1 : 0, !xy && yz ? 1 : 0, !xz && !yz ? 1 : 0};
  const Lattice two{xy || xz ? 1 : 0, !xy || yz ? 1 : 0, !xz || !yz ? 1 : 0};
  const Lattice base{static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
                     static_cast<std::int64_t>(cell.z)};
  double sum = 0;
  double shift = 0;
  for (const Lattice& corner : {Lattice{0, 0, 0}, one, two, Lattice{1, 1, 1}}) {
    const Vector offset = first - Vector{static_cast<double>(corner.x) - shift, static_cast<double>(corner.y) - shift,
                                         static_cast<double>(corner.z) - shift};
    sum += part_of({base.x + corner.x, base.y + corner.y, base.z + corner.z}, offset, seed);
    shift += 1.0 / 6;
  }
  return noise_scale * sum;
}

double layered_noise(const Vector& place, const NoiseSettings& settings) {
  double sum = 0, heights = 0, height = 1, frequency = settings.frequency;
  for (int octave = 0; octave < settings.octaves; ++octave) {
    const std::uint64_t seed = mixed_bits(settings.seed + static_cast<std::uint64_t>(octave) * splitmix_step);
    // A shift of its own, a fraction of a cell: all layers together would vanish at the origin.
    constexpr double fraction = 1.0 / 65536;
    const Vector shift{static_cast<double>(seed & 0xffff) * fraction,
                       static_cast<double>(seed >> 16 & 0xffff) * fraction,
                       static_cast<double>(seed >> 32 & 0xffff) * fraction};
    sum += height * simplex_noise(frequency * place + shift, seed);
    heights += height;
    height *= settings.roughness;
    frequency *= 2;
  }
  return heights > 0 ? sum / heights : 0;
}

Vector layered_noise_vector(const Vector& place, const NoiseSettings& settings) {
  std::array<double, 3> values{};
  for (std::size_t k = 0; k < 3; ++k) {
    NoiseSettings own = settings;
    own.seed = mixed_bits(settings.seed ^ (k + 1) * 0xA24BAED4963EE407u);
    values[k] = layered_noise(place, own);
  }
  return {values[0], values[1], values[2]};
}

}  // namespace dini
