// Transforms take any geometry and give the same type back.

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "nodes/all.h"
#include "nodes/choices.h"
#include "nodes/costs.h"
#include "nodes/versor_node.h"

namespace dini {

namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

Attempt<Versor> translation(const Vector& by) { return translation_versor(by); }

Attempt<Versor> scaling(const Point& center, double factor) { return scaling_versor(center, factor); }

Attempt<Versor> screw(const Circle& axis, double angle, double slide) {
  const std::optional<CircleCoordinates> found = coordinates(axis);
  if (!found || !found->line) return Failure{"degenerate", "the axis must be a line", "axis"};
  return screw_motor(axis, angle * radians_per_degree, slide);
}

Attempt<Versor> turn(const Circle& axis, double angle) { return screw(axis, angle, 0); }

Attempt<Versor> line_to_line(const Circle& from, const Circle& to, double amount) {
  const std::optional<Versor> motor = motor_between(from, to);
  if (!motor) return Failure{"degenerate", "a twist goes from one line to another", "from"};
  const std::optional<Generator> logarithm = motor_logarithm(*motor);
  if (!logarithm) return Failure{"degenerate", "there is no twist between these lines", "from"};
  return exponential(amount * *logarithm);
}

/// exp(amount * generator) on points. One kernel whether or not these run over axes, so that a point has the same image
/// either way.
void boost_points(Batch<Point> shape, Batch<Generator> generator, Batch<double> amount, Rule rule,
                  BatchOut<Point> out) {
  std::vector<double> storage;
  const kernels::ConstPoints in = spread(shape, out.size, storage);
  kernels::ConstGenerators generators{{}, generator.constant};
  for (std::size_t k = 0; k < generator.components.size(); ++k) generators.components[k] = generator.components[k];
  kernels::transform_points(generators, numbers(amount), rule, in, components(out), out.size);
}

template <class Element>
Element boost_element(const Element& shape, const Generator& generator, double amount, Rule rule) {
  return apply(exponential(amount * generator, rule), shape);
}

SharedMesh boost_mesh(const Context& context, const SharedMesh& shape, const Generator& generator, double amount,
                      Rule rule) {
  return apply_to_mesh(context, exponential(amount * generator, rule), shape);
}

/// `boost` and `transform` are one function under the two names that people look for.
NodeBuilder exponential_node(const char* id) {
  return node(id, boost_points, boost_element<Circle>, boost_element<Sphere>, boost_element<Generator>, boost_mesh)
      .family("transforms")
      .degenerate("point at a generator", "A fixed point stays: the point of a null pair, the poles of a real one.")
      .degenerate("circle to line", "A circle through the point that goes to infinity becomes a line.")
      .degenerate("zero radius", "A circle of radius zero keeps it.")
      .degenerate("zero direction", "The zero generator is the identity.")
      .degenerate("isoclinic generators",
                  "The two equal turns have a closed form of their own; nothing is divided by their difference.")
      .input("shape", "Points, circles, spheres, generators or meshes.")
      .input("generator", "The generator B of the rotor exp(amount B).")
      .input("amount", "How much of it.", defaults(1).soft(-2, 2))
      .input("rule", "The true exponential, or the paper's with the scalar part of the square only.", defaults("exact"))
      .cost(cost_of_moved_mesh)
      .output("shape", "The transformed shape.");
}

}  // namespace

void add_transforms(Registry& registry) {
  registry.add(
      exponential_node("boost")
          .title("Boost")
          .doc("Bends a shape with the boosting rotor of a point pair.")
          .source("Boosted Surfaces, eqs. (2), (5), (14)")
          .details(
              "A null pair keeps its own point; the point at position - direction / (amount |direction|^2) goes to "
              "infinity. Points there become the point at infinity, circles through it become lines."));

  registry.add(exponential_node("transform")
                   .title("Transform")
                   .doc("Applies the exponential of any generator to a shape.")
                   .source("Boosted Surfaces, eq. (14)"));

  registry.add(VersorNode<screw, Circle, double, double>::declare("twist")
                   .title("Twist")
                   .family("transforms")
                   .doc("Turns a shape about a line while sliding it along the line.")
                   .source("Boosted Surfaces, section 3.1, fig. 5")
                   .degenerate("circle to line", "A circle as axis is an error; one that has become a line is an axis.")
                   .input("shape", "Points, circles, spheres, generators or meshes.")
                   .input("axis", "The line to turn about.")
                   .input("angle", "The turn, right hand.", defaults(90).soft(-360, 360).unit("deg"))
                   .input("slide", "The way along the line.", defaults(0).soft(-4, 4).unit("m"))
                   .output("shape", "The twisted shape."));

  registry.add(VersorNode<line_to_line, Circle, Circle, double>::declare("twist_between")
                   .title("Twist between")
                   .family("transforms")
                   .doc("Applies a power of the screw motion that takes one line to another.")
                   .source("Boosted Surfaces, eq. (11)")
                   .details("The turn is the shorter one.")
                   .degenerate("circle to line", "A circle is an error; one that has become a line is a line.")
                   .degenerate("parallel lines", "The shift between them.")
                   .degenerate("opposite lines", "A half turn about an axis across both, chosen by a fixed rule.")
                   .input("shape", "Points, circles, spheres, generators or meshes.")
                   .input("from", "The line that is moved.")
                   .input("to", "The line that it is moved to.")
                   .input("amount", "0 nothing, 1 the whole way.", defaults(1).soft(0, 1))
                   .output("shape", "The moved shape."));

  registry.add(VersorNode<translation, Vector>::declare("translate")
                   .title("Translate")
                   .family("transforms")
                   .doc("Moves a shape.")
                   .degenerate("zero direction", "The identity.")
                   .input("shape", "Points, circles, spheres, generators or meshes.")
                   .input("vector", "By how much.", defaults({0, 0, 0}).unit("m").direction_handle())
                   .output("shape", "The moved shape."));

  registry.add(VersorNode<turn, Circle, double>::declare("rotate")
                   .title("Rotate")
                   .family("transforms")
                   .doc("Turns a shape about a line.")
                   .degenerate("circle to line", "A circle as axis is an error; one that has become a line is an axis.")
                   .input("shape", "Points, circles, spheres, generators or meshes.")
                   .input("axis", "The line to turn about.")
                   .input("angle", "The turn, right hand.", defaults(90).soft(-360, 360).unit("deg"))
                   .output("shape", "The turned shape."));

  registry.add(VersorNode<scaling, Point, double>::declare("scale")
                   .title("Scale")
                   .family("transforms")
                   .doc("Scales a shape about a point.")
                   .input("shape", "Points, circles, spheres, generators or meshes.")
                   .input("center", "The point that stays.", defaults({0, 0, 0}).unit("m").position_handle())
                   .input("factor", "The factor; it must be positive.", defaults(1).hard(1e-9, 1e9).soft(0.1, 4))
                   .output("shape", "The scaled shape."));
}

}  // namespace dini
