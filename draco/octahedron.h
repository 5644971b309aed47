#pragma once

// Unit vectors as points of a square: an octahedron unfolded (Meyer et al. 2010), as Draco streams hold normals.

#include <array>
#include <cstdint>

namespace dini {

/// A point of the square of side 2^bits - 2.
struct SquarePoint {
  std::int32_t s = 0;
  std::int32_t t = 0;
  friend bool operator==(const SquarePoint&, const SquarePoint&) = default;
};

/// The square at some number of bits: its points, and the steps between them.
class Octahedron {
 public:
  /// Directions shorter than this (the sum of their coordinates) are none.
  static constexpr double shortest_direction = 1e-6;

  /// `bits` in 2..30.
  explicit Octahedron(int bits) : steps_((1 << bits) - 1), center_((1 << (bits - 1)) - 1) {}

  /// How many different coordinates there are; steps are counted modulo this.
  std::int32_t steps() const { return steps_; }
  /// The coordinate of the middle, and the distance from there to the border.
  std::int32_t center() const { return center_; }

  /// The point for a direction of any length; for (nearly) none that of the x axis. Of the points that stand for one
  /// direction along the border always the same. Rounds as libdraco does, in double precision.
  SquarePoint point(const std::array<float, 3>& direction) const;

  /// The step from `predicted` to `point` as a decoder undoes it: both are mirrored and turned so that the prediction
  /// comes to lie in one quarter of the middle, where steps are shortest. Each coordinate in 0..steps() - 1.
  SquarePoint step(SquarePoint predicted, SquarePoint point) const;

 private:
  SquarePoint canonical(SquarePoint point) const;
  SquarePoint mirrored(SquarePoint point) const;

  std::int32_t steps_;
  std::int32_t center_;
};

}  // namespace dini
