#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// What can be said about a mesh in numbers, in meters. Vertices at exactly equal positions count as one, so that
/// texture seams and sharp edges do not open a closed mesh; vertices of no triangle do not count.
struct Measures {
  double area = 0;
  double volume = 0;  ///< signed, by the divergence theorem: positive for outward faces; enclosed only when `closed`
  std::size_t vertices = 0;   ///< distinct positions that triangles use
  std::size_t triangles = 0;  ///< those with three distinct corners
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;  ///< edges of exactly one triangle
  long long euler = 0;             ///< vertices - edges + triangles: 2 for a sphere, 0 for a torus
  double diagonal = 0;             ///< of the bounds
  Point minimum, maximum;          ///< exact bounds; the origin for an empty mesh
  bool closed = false;             ///< every edge has two triangles that run along it in opposite directions
};

/// Measures a mesh that keeps its invariants (geometry/validate.h). Area and volume are summed with compensation, to
/// 1e-12 relative; the volume relative to the middle of the bounds. Linear time. Stopped early: the numbers are
/// meaningless.
Measures measure(const Mesh& mesh, const Cancel& cancel);

}  // namespace dini
