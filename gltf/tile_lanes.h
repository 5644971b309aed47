#pragma once

// What is done to all vertices of a tile, for many at once (Highway). Every instruction set gives the same bits.

#include <array>
#include <cstddef>
#include <cstdint>

namespace dini::tile_lanes {

/// The least and the greatest of `count` indices; of none the greatest possible and 0.
struct IndexRange {
  std::uint32_t least, greatest;
};
IndexRange range_of(const std::uint32_t* indices, std::size_t count);

/// Writes values[stride * vertices[i]] as floats, in their order. False when any of them is not within `limit`, or not
/// a number. Widens the bounds to the floats; none of these is -0.
struct Bounds {
  float minimum, maximum;
};
bool round_values(const double* values, std::size_t stride, const std::uint32_t* vertices, std::size_t count,
                  double limit, float* out, Bounds& bounds);

/// Writes the three components of vectors as floats. False when the absolute components of any of them sum up to
/// `least` or less, or to `greatest` or more: what was written of those means nothing.
bool round_vectors(const std::array<const double*, 3>& components, const std::uint32_t* vertices, std::size_t count,
                   double least, double greatest, const std::array<float*, 3>& out);

}  // namespace dini::tile_lanes
