#pragma once

#include <cstddef>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A closed sphere with outward faces and exact normals. `segments` run around the z axis (at least 3), `rings` from
/// the upper pole to the lower one (at least 2); fewer are taken as the least. u runs along rings, v along segments. A
/// radius that is not positive, or a center or radius that is not finite or beyond 1e16, gives an empty mesh.
Mesh sphere_mesh(const Point& center, double radius, std::size_t segments, std::size_t rings, const Cancel& cancel);

/// A closed torus around `axis` with outward faces and exact normals: `segments` around the axis, `sides` around the
/// tube (both at least 3; fewer are taken as the least). u runs around the axis, v around the tube from the outer
/// equator. A minor radius above the major one passes through itself. A zero axis is taken as e3. Radii that are not
/// positive, or anything that is not finite or beyond 1e16, gives an empty mesh.
Mesh torus_mesh(const Point& center, const Vector& axis, double major_radius, double minor_radius, std::size_t segments,
                std::size_t sides, const Cancel& cancel);

}  // namespace dini
