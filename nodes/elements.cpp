#include "algebra/construct.h"
#include "algebra/extract.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/held_radius.h"

namespace dini {

namespace {

Point point_at_position(const Point& position) { return position; }

struct CircleInputs {
  Point center;
  Vector normal;
  double radius;
};

Attempt<Circle> circle_element(const CircleInputs& in) {
  if (in.normal == Vector{}) return Failure{"degenerate", "the normal of a circle must not be zero", "normal"};
  const Circle circle = circle_from(in.center, in.normal, in.radius);
  if (const std::optional<CircleCoordinates> found = coordinates(circle); !found || lost(found->radius, in.radius)) {
    return too_far_for(in.radius, in.center);
  }
  return circle;
}

struct LineInputs {
  Point point;
  Vector direction;
};

Attempt<Circle> line_element(const LineInputs& in) {
  if (in.direction == Vector{}) return Failure{"degenerate", "the direction of a line must not be zero", "direction"};
  return line_from(in.point, in.direction);
}

struct PointPairInputs {
  Point position;
  Vector direction;
  double split;
};

Generator point_pair(const PointPairInputs& in) { return split_pair(in.position, in.direction, in.split); }

struct TwoPointsInputs {
  Point a;
  double weight_a;
  Point b;
  double weight_b;
};

std::tuple<Generator, double> pair_through(const TwoPointsInputs& in) {
  const PointProduct product = point_product(in.a, in.weight_a, in.b, in.weight_b);
  return {product.generator, product.scalar};
}

Generator flat(const Point& position) { return flat_point(position); }

Generator free_direction(const Vector& direction) { return direction_generator(direction); }

Attempt<Generator> rotation_about(const Circle& axis) {
  const std::optional<CircleCoordinates> found = coordinates(axis);
  if (!found || !found->line) return Failure{"degenerate", "the axis of a rotation must be a line", "axis"};
  return rotation_generator(axis);
}

}  // namespace

void add_elements(Registry& registry) {
  registry.add(node("point", point_at_position)
                   .title("Point")
                   .family("elements")
                   .synonyms({"position", "location", "dot", "vertex", "empty"})
                   .doc("A position in space.")
                   .input("position", "Where it is.", defaults({0, 0, 0}).unit("m").position_handle())
                   .passes_on()
                   .output("point", "The point."));

  registry.add(
      node("circle", circle_element)
          .title("Circle")
          .family("elements")
          .synonyms({"ring", "loop", "round", "disc", "arc", "hoop"})
          .doc("An oriented circle; it runs counter-clockwise about its normal.")
          .details("A radius below a few ten-millionths of the distance from the origin is lost in round-off "
                   "and an error.")
          .degenerate("zero radius", "The degenerate circle at the center, which keeps its normal.")
          .degenerate("zero direction", "A zero normal is an error.")
          .input("center", &CircleInputs::center, "Its center.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("normal", &CircleInputs::normal, "Axis direction, of any length.",
                 defaults({0, 0, 1}).direction_handle("center"))
          .input("radius", &CircleInputs::radius, "Its radius.",
                 defaults(1).hard(0, 1e9).soft(0, 4).unit("m").radius_handle("center", "normal"))
          .output("circle", "The circle."));

  registry.add(
      node("line", line_element)
          .title("Line")
          .family("elements")
          .synonyms({"axis", "straight", "ray", "edge"})
          .doc("An oriented line: a circle through infinity.")

          .degenerate("zero direction", "An error.")
          .input("point", &LineInputs::point, "A point on it.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("direction", &LineInputs::direction, "Where it runs, of any length.",
                 defaults({0, 0, 1}).direction_handle("point"))
          .output("circle", "The line, as a circle through infinity."));

  registry.add(node("point_pair", point_pair)
                   .title("Point pair")
                   .family("elements")
                   .synonyms({"dipole", "tangent", "bend", "tangent vector", "handle", "boost generator"})
                   .doc("A generator of boosts: a tangent vector at a point, null or split into two poles.")
                   .source("Boosted Surfaces, eqs. (1), (4), fig. 8")
                   .details("With split s the square of the pair is 2 s |direction|^2.")
                   .degenerate("zero direction", "The zero generator: its exponential is the identity.")
                   .input("position", &PointPairInputs::position, "Where the tangent sits.",
                          defaults({0, 0, 0}).unit("m").position_handle())
                   .input("direction", &PointPairInputs::direction, "The tangent; its length is the strength, in 1/m.",
                          defaults({0, 0, 1}).direction_handle("position"))
                   .input("split", &PointPairInputs::split, "0 null, above 0 real, below 0 imaginary.",
                          defaults(0).hard(-1e9, 1e9).soft(-1, 1))
                   .output("generator", "The point pair."));

  registry.add(
      node("point_pair_through", pair_through)
          .title("Point pair through two points")
          .family("elements")
          .synonyms({"dipole", "two points", "poles", "segment"})
          .doc("The geometric product of two weighted points: a scalar and the point pair that joins them.")
          .source("Boosted Surfaces, eqs. (19), (20)")
          .details("The weight replaces the no coefficient of a point.")
          .degenerate("coincident points", "Equal weights give the zero generator.")
          .degenerate(
              "w = -1",
              "With both weights -1 the scalar of a unit pair about the origin is 0 and the generator alone is left.")
          .input("a", &TwoPointsInputs::a, "First point.",
                 defaults({0, 0, 1}).unit("m").position_handle().title("First point"))
          .input("weight_a", &TwoPointsInputs::weight_a, "Weight of its no coefficient.",
                 defaults(1).hard(-1e9, 1e9).soft(-1, 1).title("First weight"))
          .input("b", &TwoPointsInputs::b, "Second point.",
                 defaults({0, 0, -1}).unit("m").position_handle().title("Second point"))
          .input("weight_b", &TwoPointsInputs::weight_b, "Weight of its no coefficient.",
                 defaults(1).hard(-1e9, 1e9).soft(-1, 1).title("Second weight"))
          .output("generator", "The bivector part of the product.")
          .output("scalar", "The scalar part of the product."));

  registry.add(node("flat_point", flat)
                   .title("Flat point")
                   .family("elements")
                   .synonyms({"scaling", "dilation", "zoom"})
                   .doc("A generator of scaling about a point: exp(k p^ni) scales by e^(2k).")
                   .source("Boosted Surfaces, section 4")
                   .input("position", "The center of the scaling.", defaults({0, 0, 0}).unit("m").position_handle())
                   .output("generator", "The flat point p^ni."));

  registry.add(node("direction", free_direction)
                   .title("Direction")
                   .family("elements")
                   .synonyms({"translation", "shift", "move generator"})
                   .doc("A generator of translation: exp(k v^ni) moves by -2 k v.")
                   .source("Boosted Surfaces, section 4")
                   .degenerate("zero direction", "The zero generator: its exponential is the identity.")
                   .input("direction", "The direction v.", defaults({0, 0, 1}).direction_handle())
                   .output("generator", "The direction v^ni."));

  registry.add(node("rotation", rotation_about)
                   .title("Rotation")
                   .family("elements")
                   .synonyms({"turn", "spin", "revolve", "dual line"})
                   .doc("A generator of rotation about a line: exp(k B) turns by -2 k radians, right hand.")
                   .source("Boosted Surfaces, section 4")
                   .details("The generator is the dual of the line, of unit length.")
                   .degenerate("circle to line", "A circle is an error; one that has become a line is an axis.")
                   .input("axis", "The line to turn about.", required().title("Line"))
                   .output("generator", "The dual line."));
}

}  // namespace dini
