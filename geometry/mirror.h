#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A unit normal at `place` as a mirror shows it, at the image of the place; the normal itself where the place goes to
/// infinity. `mirror` is one, see algebra/reflection.h.
Vector reflected_normal(const Sphere& mirror, const Vector& normal, const Point& place);

/// A mesh and its image in a plane or a sphere, as one mesh; the image is wound the other way, so that its outside is
/// outside.
///
/// Vertices no farther than `tolerance` meters from the mirror are moved onto it and belong to both halves: a half
/// object whose border lies there comes out closed. Where the normal at such a vertex leans out of the mirror by more
/// than 30 degrees the vertex is doubled in place, so that the ridge shows. Triangles that lie in the mirror with all
/// three corners would be a wall between the halves, and are left out. Images may be at infinity. Tiles are those of
/// the mesh, twice. Stopped early: an empty mesh.
Mesh with_mirror_image(const Mesh& mesh, const Sphere& mirror, double tolerance, const Cancel& cancel);

}  // namespace dini
