#pragma once

#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A connected part of a curve: distinct neighbors, all finite. A closed piece does not repeat its first point.
struct CurvePiece {
  std::vector<Vector> points;
  bool closed = false;
};

/// The parts of a curve within `clip_radius` of the origin, cut on that sphere, in order along the curve; each has two
/// points or more, a closed one three. A curve that runs through infinity between two points is cut there too.
/// Stopped early: only some of them.
std::vector<CurvePiece> curve_pieces(const Polyline& curve, double clip_radius, const Cancel& cancel);

}  // namespace dini
