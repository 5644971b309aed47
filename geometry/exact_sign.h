#pragma once

#include "algebra/vector.h"

namespace dini {

/// The exact sign, -1, 0 or 1, of the volume of the tetrahedron a b c d: 1 where d is on the front side of the triangle
/// a b c. Coordinates are zero, or of magnitudes in [1e-60, 1e20]: then nothing overflows or vanishes.
int side_of_plane(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

/// The exact sign of the area of the triangle a b c seen along an axis (0: x, 1: y, 2: z, towards the origin): 1 where
/// it runs counter-clockwise. The same coordinates as above.
int turn_seen_along(int axis, const Vector& a, const Vector& b, const Vector& c);

}  // namespace dini
