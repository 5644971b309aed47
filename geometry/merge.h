#pragma once

#include <span>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// One mesh of all triangles of `meshes`, in order; nothing is welded. An attribute is kept when any mesh has it:
/// missing normals are computed, missing texture coordinates are zero. Vertex colors also appear when the meshes differ
/// in their own color, so that every part keeps its look; a mesh without vertex colors is filled with its own color.
/// The result's own color is the first mesh's. Tiles are kept, a mesh without tiles is one. Null pointers and no meshes
/// give an empty mesh. The vertices of all meshes together must be fewer than 2^32. Stopped early: an empty mesh.
Mesh merge(std::span<const SharedMesh> meshes, const Cancel& cancel);

}  // namespace dini
