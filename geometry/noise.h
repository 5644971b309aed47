#pragma once

#include <cstdint>

#include "algebra/vector.h"

namespace dini {

/// Several layers of noise, each finer than the one before it.
struct NoiseSettings {
  double frequency = 1;    ///< features per meter, about
  int octaves = 3;         ///< layers; each has twice the frequency of the one before it
  double roughness = 0.5;  ///< share of the height of the one before it, in [0, 1]
  std::uint64_t seed = 1;
};

/// Simplex noise at a place, in [-1, 1]: smooth (its second derivative is continuous), zero on average, and the same on
/// every machine, being made of integer hashes, products and sums only (Perlin, "Noise hardware", 2001; Gustavson,
/// "Simplex noise demystified", 2005). Places at infinity, or so far that a double has no fraction there, give 0.
double simplex_noise(const Vector& place, std::uint64_t seed);

/// Layers of simplex noise, divided by the sum of their heights: in [-1, 1]. Layers are shifted, so that not all of
/// them are zero at the origin.
double layered_noise(const Vector& place, const NoiseSettings& settings);

/// Three of them, independent: each in [-1, 1].
Vector layered_noise_vector(const Vector& place, const NoiseSettings& settings);

}  // namespace dini
