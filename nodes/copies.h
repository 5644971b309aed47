#pragma once

// Copies of a shape of any kind, each moved by a versor of its own, along an axis that a node makes.

#include "nodes/versor_node.h"

namespace dini {

inline Attempt<Point> moved_copy(const Context&, const Versor& versor, const Point& shape) {
  Vector image;
  kernels::transform_points(versor, {&shape.x, &shape.y, &shape.z}, {&image.x, &image.y, &image.z}, 1);
  return to_point(image);
}

template <class Element>
Attempt<Element> moved_copy(const Context& context, const Versor& versor, const Element& shape) {
  const Element moved = apply(versor, shape);
  if constexpr (!std::is_same_v<Element, Generator>) warn_of_lost_radius(context, versor, shape, moved);
  return moved;
}

inline Attempt<SharedMesh> moved_copy(const Context& context, const Versor& versor, const SharedMesh& shape) {
  return apply_to_mesh(context, versor, shape);
}

inline Attempt<SharedField> moved_copy(const Context&, const Versor& versor, const SharedField& shape) {
  return carried(shape, versor);
}

/// `count` copies of a shape, copy i moved by `versor_of(i)`.
template <class Shape, class VersorOf>
Attempt<Made<Shape>> moved_copies(const Context& context, const Shape& shape, std::size_t count,
                                  const VersorOf& versor_of) {
  if (context.cancel().stopped()) return Made<Shape>{};
  Made<Shape> copies{Column<Shape>(count)};
  for (std::size_t i = 0; i < count && !context.cancel().stopped(); ++i) {
    Attempt<Shape> copy = moved_copy(context, versor_of(i), shape);
    if (!copy) return copy.error();
    copies.values.set(i, *std::move(copy));
  }
  return copies;
}

/// Copies of a mesh share all but positions and normals with it; a field that is moved holds more than its wire counts.
inline RunCost cost_of_copies(const RunSize& size) {
  return {0, 48 * size.vertices, 450 * size.fields - 56 * size.vertices};
}

/// The functions of a node that copies: `copies<Shape>` for every kind of shape.
template <template <class> class Copies>
auto copying_node(const char* id) {
  return node(id, Copies<Point>::make, Copies<Circle>::make, Copies<Sphere>::make, Copies<Generator>::make,
              Copies<SharedMesh>::make, Copies<SharedField>::make)
      .family("transforms")
      .cost(cost_of_copies);
}

}  // namespace dini
