#pragma once

#include <cstdint>
#include <vector>

#include "draco/edgebreaker.h"

namespace dini {

/// Three vertices that a decoder knows before another: it is expected at `after + before - across`, which completes a
/// parallelogram over the edge from `after` to `before`. Where there is no such triangle, all three are the vertex
/// decoded last.
struct Parallelogram {
  std::uint32_t after = 0;
  std::uint32_t before = 0;
  std::uint32_t across = 0;
};

/// The order in which decoders read the attributes of vertices (depth first over the rebuilt triangles; Draco bitstream
/// 2.2, "EdgeBreakerTraverser"), and what each is predicted from. The numbers are those of the mesh. The first vertex
/// is predicted from itself: nothing is known before it.
struct VertexOrder {
  std::vector<std::uint32_t> vertices;
  std::vector<Parallelogram> parallelograms;
};

VertexOrder vertex_order(const CornerTable& table, const Edgebreaker& walk);

}  // namespace dini
