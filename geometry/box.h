#pragma once

#include <cstddef>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A closed axis-parallel box with outward faces and flat normals; `size` are its edge lengths. Each face is a grid of
/// `segments` by `segments` quads (at least 1) with vertices of its own, at exactly equal positions along common edges.
/// u and v run from 0 to 1 on each face. A size that is not positive, or anything that is not finite or beyond 1e16,
/// gives an empty mesh.
Mesh box_mesh(const Point& center, const Vector& size, std::size_t segments, const Cancel& cancel);

}  // namespace dini
