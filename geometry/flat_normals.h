#pragma once

#include <cstddef>

#include "geometry/raw_mesh.h"

namespace dini {

/// Gives the triangles from `first_triangle` on one normal each, that of their plane, so that their edges show. All of
/// their vertices, and none of other triangles, stand from `first_vertex` on. They are copied where such triangles
/// meet, except where normals agree to a millionth. A triangle without an area gets none. False, with nothing changed,
/// when the mesh would have more than `most_vertices`, or the work was stopped.
bool make_flat(RawMesh& raw, std::size_t first_vertex, std::size_t first_triangle, std::size_t most_vertices,
               const Cancel& cancel);

}  // namespace dini
