#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

struct SmoothOptions {
  std::size_t iterations = 10;
  double strength = 0.5;     ///< in [0, 1]: how far a vertex goes to the middle of its neighbors; 1 is two thirds
  bool keeps_volume = true;  ///< each step is followed by a larger one back (Taubin), so that nothing shrinks
  bool keeps_border = true;  ///< vertices on a border stay; else they go to the middle of their neighbors on it
};

/// The positions of a mesh smoothed: each vertex moves towards the middle of its neighbors, all at once, again and
/// again. Vertices at one position are one, so that seams stay closed. Edges of one triangle, or of more than two, are
/// the border; where more than two of them meet a vertex stays. Steps that keep the volume are those of Taubin, "A
/// signal processing approach to fair surface design" (1995), with a pass band of 0.02. Stopped early: positions that
/// mean nothing.
Column<Point> smoothed_positions(const Mesh& mesh, const SmoothOptions& options, const Cancel& cancel);

}  // namespace dini
