#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"
#include "geometry/scalar_field.h"

namespace dini {

/// The box that is looked into, and how finely.
struct ImplicitOptions {
  Vector low, high;             ///< low below high in every coordinate
  std::size_t resolution = 64;  ///< cells along the longest side
  std::size_t most_vertices = 0;
  std::size_t most_field_bytes = 0;  ///< of what is left of the field in parts of the box: at any time, and kept
};

struct ImplicitSurface {
  Mesh mesh;
  bool too_large = false;  ///< it would have more vertices than accepted, and none were made after those; it is empty
  bool capped = false;     ///< the solid reaches the border of the box, where it was closed
};

/// The surface of the solid of a field within a box, with outward faces and unit normals from the gradient: dual
/// contouring on cells of which only those are looked at where the bounds of the field allow a surface.
///
/// The mesh is closed and two-manifold: each edge has two triangles, and vertices at one place, which differ in their
/// normals along an edge of the surface, count as one. A solid that reaches the border of the box is closed there. What
/// is smaller than a cell may be missed, or joined to what is beside it. An empty solid gives an empty mesh. Stopped
/// early: not a whole mesh.
ImplicitSurface implicit_mesh(const SharedField& field, const ImplicitOptions& options, const Cancel& cancel);

}  // namespace dini
