#pragma once

// The one grid that every mesh of a scene is rounded to. Tiles and parts that share a vertex round it the same way, so
// no seam opens. All arithmetic is float32 in the order of the Draco decoder, so bounds are known exactly without
// decoding.

#include <array>
#include <limits>

namespace dini {

/// How far rounding to a float moves a number, as a share of it.
inline constexpr double float_rounding = 0x1p-24;

/// An axis-aligned box of float coordinates; empty until something is included.
struct FloatBox {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> minimum = {infinity, infinity, infinity};
  std::array<float, 3> maximum = {-infinity, -infinity, -infinity};

  bool empty() const { return !(minimum[0] <= maximum[0]); }
  void include(const std::array<float, 3>& point);
  void include(const FloatBox& box);

  /// The largest absolute coordinate; 0 for the empty box.
  float largest() const;
};

/// Cubic cells of size range / (2^bits - 1), the first one centered on `origin`.
class QuantizationGrid {
 public:
  QuantizationGrid() = default;

  /// The grid that covers `box`: origin at its minimum, range its largest extent, widened to about 1e-30 so that it is
  /// safe to divide by. A single point has range 1 and is exact. An empty box gives the grid of the point zero. `bits`
  /// in 1..20.
  QuantizationGrid(const FloatBox& box, int bits);

  /// The box that the grid covers. Its minimum is the origin and its largest extent, in float32, the range.
  const FloatBox& box() const { return box_; }
  float range() const { return range_; }
  int bits() const { return bits_; }

  /// What a decoder returns for `value` on `axis`, bit for bit. `value` lies in the box the grid was made from.
  /// The result can lie outside the box by up to half a cell.
  float decoded(std::size_t axis, float value) const;

  /// The box of the decoded points whose source points have the box `box`.
  FloatBox decoded(const FloatBox& box) const;

  /// Bound in meters, per axis, on |decoded - original| for an original given in double precision inside the box: half
  /// a cell, plus every float rounding on the way (to float, to cells and back). Not smaller than the true error.
  double position_error() const;

 private:
  float cells() const;

  FloatBox box_ = {{0, 0, 0}, {0, 0, 0}};
  float range_ = 1;
  int bits_ = 14;
};

/// Bound in radians on the angle between a unit normal and its octahedral rounding to `bits` bits per coordinate.
double octahedral_error(int bits);

}  // namespace dini
