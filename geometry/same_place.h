#pragma once

#include "geometry/cancel.h"
#include "geometry/clip.h"
#include "geometry/column.h"

namespace dini {

/// The largest coordinate of some points, without its sign. Stopped early: of some of them.
inline double largest_coordinate_of(const Column<Point>& points, CancelEvery& looks) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size() && !looks.stopped(); ++i) {
    largest = std::max(largest, largest_component(to_vector(points[i])));
  }
  return largest;
}

/// Tells which of the points of a curve are one: those that differ by no more than round-off of its coordinates.
class SamePlace {
 public:
  SamePlace(const Column<Point>& points, CancelEvery& looks)
      : tolerance_(relative_round_off * largest_coordinate_of(points, looks)) {}

  bool operator()(const Vector& a, const Vector& b) const { return !(largest_component(a - b) > tolerance_); }

 private:
  double tolerance_;
};

}  // namespace dini
