#pragma once

// Most transforms are one versor made from their inputs. VersorNode turns such a rule into the functions for every kind
// of shape.

#include <optional>
#include <variant>

#include "graph/node_builder.h"
#include "nodes/shapes.h"

namespace dini {

/// The functions of a transform whose versor `make(parameters...)` gives, as a value or as a failure.
template <auto make, class... Parameters>
struct VersorNode {
  static std::optional<Failure> points(Batch<Point> shape, const Parameters&... parameters, BatchOut<Point> out) {
    const Attempt<Versor> versor = make(parameters...);
    if (const auto* failure = std::get_if<Failure>(&versor)) return *failure;
    return apply_to_points(std::get<Versor>(versor), shape, out);
  }

  template <class Element>
  static Attempt<Element> element(const Element& shape, const Parameters&... parameters) {
    const Attempt<Versor> versor = make(parameters...);
    if (const auto* failure = std::get_if<Failure>(&versor)) return *failure;
    return apply(std::get<Versor>(versor), shape);
  }

  static Attempt<SharedMesh> mesh(const Context& context, const SharedMesh& shape, const Parameters&... parameters) {
    const Attempt<Versor> versor = make(parameters...);
    if (const auto* failure = std::get_if<Failure>(&versor)) return *failure;
    return apply_to_mesh(context, std::get<Versor>(versor), shape);
  }

  static NodeBuilder declare(const char* id) {
    return node(id, points, element<Circle>, element<Sphere>, element<Generator>, mesh);
  }
};

}  // namespace dini
