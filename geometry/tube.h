#pragma once

#include <cstddef>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

struct TubeOptions {
  double radius = 0.01;      ///< meters
  std::size_t sides = 12;    ///< corners of the cross-section; fewer than 3 are taken as 3
  double clip_radius = 1e3;  ///< meters from the origin, at most 1e17; farther points count as at infinity
  bool capped = true;        ///< open ends carry caps
};

/// A tube with outward faces around a curve.
///
/// Cross-sections are perpendicular to the curve and do not turn about it (rotation-minimizing frames by double
/// reflection: Wang, Juettler, Zheng, Liu, "Computation of Rotation Minimizing Frames", 2008); around a closed curve
/// the turn that is left is spread evenly over its length, so that the seam closes. Closed tubes are welded: Euler
/// number 0. Open ends carry flat caps with normals and vertices of their own, at the positions of the rim. Smooth
/// normals; u runs along each piece by length in [0, 1], v around by side/sides (not doubled at welded seams). Where
/// the curve leaves `clip_radius` it is cut; points that are not finite, and a step that turns back against both of its
/// neighbors and is longer than them together (the curve went through infinity), leave a gap. Every piece is capped.
/// Steps shorter than round-off are skipped. A piece of fewer than two distinct points is left out, a closed curve of
/// two is taken as open. Bends tighter than the radius pass through themselves; corners are not mitered. A radius that
/// is not positive and finite gives an empty mesh. Triangles come in tiles of at most 128 x 128 quads, caps in the
/// tiles they touch. Stopped early: an empty mesh.
Mesh tube(const Polyline& curve, const TubeOptions& options, const Cancel& cancel);

}  // namespace dini
