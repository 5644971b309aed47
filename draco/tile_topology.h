#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "draco/vertex_order.h"

namespace dini {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

/// All of a compressed tile that depends on its triangles only: the longest part of compressing it.
struct TileTopology {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< what it is of
  std::vector<char> connectivity;                       ///< as the stream holds it
  VertexOrder order;

  /// Memory that it takes, in bytes.
  std::size_t size() const;
};

/// The topology of triangles with three different vertices below `vertices`, each of which is used. Null when they are
/// no manifold (draco/corner_table.h).
std::shared_ptr<const TileTopology> tile_topology(Triangles triangles, std::size_t vertices);

}  // namespace dini
