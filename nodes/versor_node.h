#pragma once

// Most transforms are one versor made from their inputs. VersorNode turns such a rule into the functions for every kind
// of shape.

#include <optional>
#include <type_traits>
#include <variant>

#include "algebra/extract.h"
#include "graph/node_builder.h"
#include "nodes/costs.h"
#include "nodes/moved_field.h"
#include "nodes/shapes.h"

namespace dini {

inline bool is_straight(const CircleCoordinates& circle) { return circle.line; }
inline bool is_straight(const SphereCoordinates& sphere) { return sphere.plane; }

/// Warns when a circle or sphere with a radius has come out without, because its radius is lost in the round-off of its
/// distance from the origin. Operators without an inverse take everything to one point, which is no reason to warn.
template <class Element>
void warn_of_lost_radius(const Context& context, const Versor& versor, const Element& before, const Element& after) {
  const auto found = coordinates(after);
  if (!found || found->radius > 0 || is_straight(*found)) return;
  const auto given = coordinates(before);
  if (!given || (given->radius == 0 && !is_straight(*given))) return;
  if (!has_inverse(versor)) return;
  context.warn({"degenerate", "a radius is smaller than the round-off at its place, and counts as zero", "shape"});
}

/// The functions of a transform whose versor `make(inputs)` gives, as a value or as a failure.
template <auto make>
struct VersorNode {
  using Inputs = decltype(inputs_of(make));

  static std::optional<Failure> points(const Batch<Point>& shape, const Inputs& in, BatchOut<Point> out) {
    const Attempt<Versor> versor = make(in);
    if (!versor) return versor.error();
    return apply_to_points(*versor, shape, out);
  }

  template <class Element>
  static Attempt<Element> element(const Context& context, const Element& shape, const Inputs& in) {
    const Attempt<Versor> versor = make(in);
    if (!versor) return versor.error();
    const Element moved = apply(*versor, shape);
    if constexpr (!std::is_same_v<Element, Generator>) warn_of_lost_radius(context, *versor, shape, moved);
    return moved;
  }

  static Attempt<SharedMesh> mesh(const Context& context, const SharedMesh& shape, const Inputs& in) {
    const Attempt<Versor> versor = make(in);
    if (!versor) return versor.error();
    return apply_to_mesh(context, *versor, shape);
  }

  static Attempt<SharedField> field(const SharedField& shape, const Inputs& in) {
    const Attempt<Versor> versor = make(in);
    if (!versor) return versor.error();
    return carried(shape, *versor);
  }

  static auto declare(const char* id) {
    return node(id, points, element<Circle>, element<Sphere>, element<Generator>, mesh, field).cost(cost_of_moved_mesh);
  }
};

}  // namespace dini
