#pragma once

#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A curve in which a plane cuts a mesh.
struct Contour {
  std::vector<Vector> points;  ///< no two neighbors agree; a closed one does not repeat its first point
  bool closed = false;
  double length = 0;  ///< meters
  double area = 0;  ///< enclosed, square meters: positive where it runs around material, negative around a hole; 0 open
};

/// The contours of a mesh in the plane of the points x with normal . x = height, the longest first; `normal` is a unit
/// vector. Vertices at one position are one. Corners in the plane count as above it, so that the bottom of a solid that
/// stands in the plane gives no contour and its top does, and nothing is cut twice. Material is to the left of a
/// contour, seen with the normal towards the viewer. A closed one starts where it is farthest along a fixed direction.
/// Where a mesh is open, or its triangles do not agree about its outside, contours are open. None where the plane cuts
/// nothing. Stopped early: contours that mean nothing.
std::vector<Contour> contours_of(const Mesh& mesh, const Vector& normal, double height, const Cancel& cancel);

/// `count` points on a contour, to be joined with the last to the first; an open contour is run there and back. They
/// are at about even lengths, with every corner among them where there are no more corners than points.
Column<Point> contour_points(const Contour& contour, std::size_t count, const Cancel& cancel);

}  // namespace dini
