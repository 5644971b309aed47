#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/cancel.h"
#include "gltf/lines.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// A mesh as printers want it: every place once, whatever normals and colors meet there.
struct JoinedMesh {
  FloatPoints places;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of places
  std::vector<std::array<std::uint32_t, 3>> corners;    ///< of vertices of the tile, for each of the triangles
  bool closed = false;  ///< each edge is once in each of its directions, so there is an inside
};

/// Joins vertices that have exactly the same place; triangles that lose a corner by it are left out. Stopped early: not
/// the whole mesh.
JoinedMesh joined_mesh(const Tile& tile, const Cancel& cancel);

}  // namespace dini
