// From one element to another: the motion that does it, its generator, and the elements on the way.

#include "algebra/between.h"

#include "nodes/all.h"
#include "nodes/versor_node.h"

namespace dini {

/// Turns, shifts and scalings only, or the root of the ratio of both circles.
enum class BetweenMethod { similarity, conformal };

template <>
struct ChoiceNames<BetweenMethod> {
  static constexpr std::array<std::string_view, 2> names = {"similarity", "conformal"};
};

namespace {

constexpr const char* method_doc =
    "A turn with a shift and a scaling, or the square root of the ratio of the circles; spheres do not use it.";

Attempt<Generator> generator_between(const Circle& from, const Circle& to, BetweenMethod method) {
  const auto a = coordinates(from), b = coordinates(to);
  if (!a || (!a->line && a->radius == 0)) {
    return Failure{"degenerate", "it takes a line, or a circle with a radius", "from"};
  }
  if (!b || (!b->line && b->radius == 0))
    return Failure{"degenerate", "it takes a line, or a circle with a radius", "to"};
  if (method == BetweenMethod::similarity) {
    if (const auto found = similarity_between(from, to)) return *found;
    return Failure{"degenerate", "no turn, shift and scaling takes a line to a circle, but method conformal does",
                   "to"};
  }
  if (const auto found = rotor_between(from, to)) return *found;
  return Failure{"degenerate", "of many motions between these circles none is the nearest", "to"};
}

Attempt<Generator> generator_between(const Sphere& from, const Sphere& to, BetweenMethod) {
  if (const auto ratio = sphere_ratio(from, to)) return ratio->factor * ratio->plane;
  return Failure{"degenerate", "a sphere of radius zero has no inverse, so there is no ratio", "from"};
}

struct TransformBetweenInputs {
  Circle from, to;
  double amount;
  BetweenMethod method;
};

Attempt<Versor> circle_to_circle(const TransformBetweenInputs& in) {
  const Attempt<Generator> generator = generator_between(in.from, in.to, in.method);
  if (!generator) return generator.error();
  return exponential(in.amount * *generator);
}

template <class Element>
struct LogarithmInputs {
  Element to;
  BetweenMethod method;
};

template <class Element>
Attempt<Generator> logarithm(const Element& from, const LogarithmInputs<Element>& in) {
  return generator_between(from, in.to, in.method);
}

template <class Element>
struct BlendInputs {
  Element to;
  double amount;
  BetweenMethod method;
};

template <class Element>
Attempt<Element> blended(const Element& from, const BlendInputs<Element>& in) {
  const Attempt<Generator> generator = generator_between(from, in.to, in.method);
  if (!generator) return generator.error();
  return apply(exponential(in.amount * *generator), from);
}

}  // namespace

void add_between(Registry& registry) {
  constexpr const char* opposite =
      "Half a turn about an axis across, chosen by a fixed rule, takes a circle or line to itself run the other way.";
  registry.add(
      VersorNode<circle_to_circle>::declare("transform_between")
          .title("Transform between")
          .family("transforms")
          .synonyms({"morph", "circle to circle", "carry", "align", "spiral"})
          .doc("Applies a power of the motion that takes one circle or line to another.")
          .source("Dorst and Valkenburg, Square root and logarithm of rotors in 3D conformal geometric algebra (2011)")
          .details("A similarity turns by the shorter way between the normals while it scales and shifts: a spiral "
                   "about one point. The conformal motion is the square root of the ratio of the circles: it moves "
                   "nothing that both have in common, bends shapes between them, and goes between lines and circles "
                   "too. Half of it twice is the whole. From sphere to sphere see boost between.")
          .degenerate("circle to line",
                      "Method similarity goes from circle to circle or line to line only: an error; "
                      "conformal goes everywhere.")
          .degenerate("zero radius", "An error: a circle of radius zero has no ratio to another.")
          .degenerate("opposite lines", opposite)
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("from", &TransformBetweenInputs::from, "The circle or line that is moved.", required().title("From"))
          .input("to", &TransformBetweenInputs::to, "The one that it is moved to.", required().title("To"))
          .input("amount", &TransformBetweenInputs::amount, "0 nothing, 1 the whole way.",
                 defaults(1).hard(-1e6, 1e6).soft(0, 1).title("Amount"))
          .input("method", &TransformBetweenInputs::method,
                 "A turn with a shift and a scaling, or the square root of "
                 "the ratio of the circles.",
                 defaults("similarity").title("Method"))
          .output("shape", "The moved shape."));

  registry.add(node("logarithm", logarithm<Circle>, logarithm<Sphere>)
                   .title("Logarithm")
                   .family("generators")
                   .synonyms({"generator between", "ratio", "motion"})
                   .doc("The generator that takes one circle or sphere to another: its exponential does.")
                   .source("Dorst and Valkenburg, Square root and logarithm of rotors in 3D conformal geometric "
                           "algebra (2011)")
                   .details("transform applies it, orbit follows it, interpolate and add blend it with others.")
                   .degenerate("opposite lines", opposite)
                   .degenerate("zero radius", "An error: a circle or sphere of radius zero has no ratio to another.")
                   .input("from", "A circle, line, sphere or plane.")
                   .input("to", &LogarithmInputs<Circle>::to, &LogarithmInputs<Sphere>::to, "Another of its kind.",
                          required().title("To"))
                   .input("method", &LogarithmInputs<Circle>::method, &LogarithmInputs<Sphere>::method, method_doc,
                          defaults("similarity").title("Method"))
                   .output("generator", "The generator."));

  registry.add(
      node("blend", blended<Circle>, blended<Sphere>)
          .title("Blend")
          .family("transforms")
          .synonyms({"in between", "morph", "interpolate circles", "tween", "lerp"})
          .doc("A circle or sphere on the way from one to another.")
          .source("Dorst and Valkenburg, Square root and logarithm of rotors in 3D conformal geometric algebra (2011)")
          .details("It is the first one moved by exp(amount * logarithm). Spheres that lie apart reach each other "
                   "through a plane.")
          .degenerate("opposite lines", opposite)
          .degenerate("zero radius", "An error: a circle or sphere of radius zero has no ratio to another.")
          .input("from", "A circle, line, sphere or plane.")
          .input("to", &BlendInputs<Circle>::to, &BlendInputs<Sphere>::to, "Another of its kind.",
                 required().title("To"))
          .input("amount", &BlendInputs<Circle>::amount, &BlendInputs<Sphere>::amount, "0 the first, 1 the second.",
                 defaults(0.5).hard(-1e6, 1e6).soft(0, 1).title("Amount"))
          .input("method", &BlendInputs<Circle>::method, &BlendInputs<Sphere>::method, method_doc,
                 defaults("similarity").title("Method"))
          .output("shape", "The circle or sphere between."));
}

}  // namespace dini
