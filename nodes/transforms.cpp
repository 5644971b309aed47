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

struct TranslateInputs {
  Vector vector;
};

Attempt<Versor> translation(const TranslateInputs& in) { return translation_versor(in.vector); }

struct ScaleInputs {
  Point center;
  double factor;
};

Attempt<Versor> scaling(const ScaleInputs& in) { return scaling_versor(in.center, in.factor); }

struct TwistInputs {
  Circle axis;
  double angle;
  double slide;
};

Attempt<Versor> screw(const TwistInputs& in) {
  const std::optional<CircleCoordinates> found = coordinates(in.axis);
  if (!found || !found->line) return Failure{"degenerate", "the axis must be a line", "axis"};
  return screw_motor(in.axis, in.angle * radians_per_degree, in.slide);
}

struct RotateInputs {
  Circle axis;
  double angle;
};

Attempt<Versor> turn(const RotateInputs& in) { return screw({in.axis, in.angle, 0}); }

struct TwistBetweenInputs {
  Circle from, to;
  double amount;
};

Attempt<Versor> line_to_line(const TwistBetweenInputs& in) {
  const std::optional<Versor> motor = motor_between(in.from, in.to);
  if (!motor) return Failure{"degenerate", "a twist goes from one line to another", "from"};
  const std::optional<Generator> logarithm = motor_logarithm(*motor);
  if (!logarithm) return Failure{"degenerate", "there is no twist between these lines", "from"};
  return exponential(in.amount * *logarithm);
}

struct BoostInputs {
  Generator generator;
  double amount;
  Rule rule;
};

/// Of points, each with a generator and an amount of its own.
struct BoostPointsInputs {
  Batch<Generator> generator;
  Batch<double> amount;
  Rule rule;
};

/// exp(amount * generator) on points. One kernel whether or not these run over axes, so that a point has the same image
/// either way.
void boost_points(const Batch<Point>& shape, const BoostPointsInputs& in, BatchOut<Point> out) {
  std::vector<double> storage;
  const kernels::ConstPoints points = spread(shape, out.size, storage);
  kernels::ConstGenerators generators{{}, in.generator.constant};
  for (std::size_t k = 0; k < in.generator.components.size(); ++k) {
    generators.components[k] = in.generator.components[k];
  }
  kernels::transform_points(generators, numbers(in.amount), in.rule, points, components(out), out.size);
}

template <class Element>
Element boost_element(const Element& shape, const BoostInputs& in) {
  return apply(exponential(in.amount * in.generator, in.rule), shape);
}

SharedMesh boost_mesh(const Context& context, const SharedMesh& shape, const BoostInputs& in) {
  return apply_to_mesh(context, exponential(in.amount * in.generator, in.rule), shape);
}

Attempt<SharedField> boost_field(const SharedField& shape, const BoostInputs& in) {
  return carried(shape, exponential(in.amount * in.generator, in.rule));
}

/// `boost` and `transform` are one function under the two names that people look for.
auto exponential_node(const char* id) {
  return node(id, boost_points, boost_element<Circle>, boost_element<Sphere>, boost_element<Generator>, boost_mesh,
              boost_field)
      .family("transforms")
      .degenerate("point at a generator", "A fixed point stays: the point of a null pair, the poles of a real one.")
      .degenerate("circle to line", "A circle through the point that goes to infinity becomes a line.")
      .degenerate("zero radius", "A circle of radius zero keeps it.")
      .degenerate("zero direction", "The zero generator is the identity.")
      .degenerate("isoclinic generators",
                  "The two equal turns have a closed form of their own; nothing is divided by their difference.")
      .input("shape", "Points, circles, spheres, generators, meshes or fields.")
      .input("generator", &BoostInputs::generator, &BoostPointsInputs::generator,
             "The generator B of the rotor exp(amount B).")
      .input("amount", &BoostInputs::amount, &BoostPointsInputs::amount, "How much of it.", defaults(1).soft(-2, 2))
      .input("rule", &BoostInputs::rule, &BoostPointsInputs::rule,
             "The true exponential, or the paper's with the scalar part of the square only.",
             defaults("exact").title("Exponential"))
      .cost(cost_of_moved_mesh)
      .output("shape", "The transformed shape.");
}

}  // namespace

void add_transforms(Registry& registry) {
  registry.add(
      exponential_node("boost")
          .title("Boost")
          .synonyms({"bend", "deform", "dipole", "stretch", "flow"})
          .doc("Bends a shape with the boosting rotor of a point pair.")
          .source("Boosted Surfaces, eqs. (2), (5), (14)")
          .details(
              "A null pair keeps its own point; the point at position - direction / (amount |direction|^2) goes to "
              "infinity. Points there become the point at infinity, circles through it become lines."));

  registry.add(exponential_node("transform")
                   .title("Transform")
                   .synonyms({"rotor", "exponential", "versor", "move", "apply"})
                   .doc("Applies the exponential of any generator to a shape.")
                   .source("Boosted Surfaces, eq. (14)"));

  registry.add(
      VersorNode<screw>::declare("twist")
          .title("Twist")
          .family("transforms")
          .synonyms({"screw", "helix", "spiral", "lathe", "spin", "revolve", "corkscrew", "coil"})
          .doc("Turns a shape about a line while sliding it along the line.")
          .source("Boosted Surfaces, section 3.1, fig. 5")
          .degenerate("circle to line", "A circle as axis is an error; one that has become a line is an axis.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("axis", &TwistInputs::axis, "The line to turn about.", required().title("Line"))
          .input("angle", &TwistInputs::angle, "The turn, right hand.", defaults(90).soft(-360, 360).unit("deg"))
          .input("slide", &TwistInputs::slide, "The way along the line.", defaults(0).soft(-4, 4).unit("m"))
          .output("shape", "The twisted shape."));

  registry.add(VersorNode<line_to_line>::declare("twist_between")
                   .title("Twist between")
                   .family("transforms")
                   .synonyms({"screw", "motion between", "morph", "align"})
                   .doc("Applies a power of the screw motion that takes one line to another.")
                   .source("Boosted Surfaces, eq. (11)")
                   .details("The turn is the shorter one.")
                   .degenerate("circle to line", "A circle is an error; one that has become a line is a line.")
                   .degenerate("parallel lines", "The shift between them.")
                   .degenerate("opposite lines", "A half turn about an axis across both, chosen by a fixed rule.")
                   .input("shape", "Points, circles, spheres, generators, meshes or fields.")
                   .input("from", &TwistBetweenInputs::from, "The line that is moved.")
                   .input("to", &TwistBetweenInputs::to, "The line that it is moved to.")
                   .input("amount", &TwistBetweenInputs::amount, "0 nothing, 1 the whole way.", defaults(1).soft(0, 1))
                   .output("shape", "The moved shape."));

  registry.add(
      VersorNode<translation>::declare("translate")
          .title("Translate")
          .family("transforms")
          .synonyms({"move", "shift", "offset", "displace"})
          .doc("Moves a shape.")
          .degenerate("zero direction", "The identity.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("vector", &TranslateInputs::vector, "By how much.", defaults({0, 0, 0}).unit("m").direction_handle())
          .output("shape", "The moved shape."));

  registry.add(
      VersorNode<turn>::declare("rotate")
          .title("Rotate")
          .family("transforms")
          .synonyms({"turn", "spin", "revolve", "orient", "lathe"})
          .doc("Turns a shape about a line.")
          .degenerate("circle to line", "A circle as axis is an error; one that has become a line is an axis.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("axis", &RotateInputs::axis, "The line to turn about.", required().title("Line"))
          .input("angle", &RotateInputs::angle, "The turn, right hand.", defaults(90).soft(-360, 360).unit("deg"))
          .output("shape", "The turned shape."));

  registry.add(VersorNode<scaling>::declare("scale")
                   .title("Scale")
                   .family("transforms")
                   .synonyms({"size", "resize", "zoom", "grow", "shrink", "enlarge"})
                   .doc("Scales a shape about a point.")
                   .input("shape", "Points, circles, spheres, generators, meshes or fields.")
                   .input("center", &ScaleInputs::center, "The point that stays.",
                          defaults({0, 0, 0}).unit("m").position_handle())
                   .input("factor", &ScaleInputs::factor, "The factor; it must be positive.",
                          defaults(1).hard(1e-9, 1e9).soft(0.1, 4))
                   .output("shape", "The scaled shape."));
}

}  // namespace dini
