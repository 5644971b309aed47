// Transforms that the paper builds from special operators: loxodromes, products of points, Hopf fibers, ratios of
// spheres.

#include "algebra/between.h"
#include "algebra/construct.h"
#include "algebra/elementary.h"
#include "algebra/extract.h"
#include "algebra/frame.h"
#include "nodes/all.h"
#include "nodes/choices.h"
#include "nodes/versor_node.h"

namespace dini {

/// The paper's composition of a boost and a twist, or true fibers of the Hopf fibration.
enum class HopfMethod { exact, paper };

template <>
struct ChoiceNames<HopfMethod> {
  static constexpr std::array<std::string_view, 2> names = {"exact", "paper"};
};

namespace {

struct LoxodromeInputs {
  Vector a;
  double lambda;
  Vector b;
  double gamma;
  double amount;
  Rule rule;
};

Attempt<Versor> loxodrome(const LoxodromeInputs& in) {
  return exponential(in.amount * Generator{in.lambda * in.a, {}, 0, in.gamma * in.b}, in.rule);
}

struct ProductInputs {
  Point a;
  double weight_a;
  Point b;
  double weight_b;
  double amount;
};

Attempt<Versor> product_of_points(const ProductInputs& in) {
  const PointProduct product = point_product(in.a, in.weight_a, in.b, in.weight_b);
  const Generator bivector = in.amount * product.generator;
  if (product.scalar == 0 && bivector == Generator{}) {
    return Failure{"degenerate", "the product of these points is zero", "amount"};
  }
  return versor_from(product.scalar, bivector);
}

struct BoostBetweenInputs {
  Sphere from, to;
  double amount;
};

/// A square root of to/from, to the power `amount`: its plane is that of the two vectors.
Attempt<Versor> sphere_to_sphere(const BoostBetweenInputs& in) {
  const std::optional<SphereRatio> ratio = sphere_ratio(in.from, in.to);
  if (!ratio) return Failure{"degenerate", "a sphere of radius zero has no inverse, so there is no ratio", "from"};
  return exponential((in.amount * ratio->factor) * ratio->plane);
}

/// The true fiber at `tilt` turns (a quarter is the axis) over the direction `outward`, for a base circle about the
/// origin: center -r tan(tilt) outward, radius r / cos(tilt), multiplied by cos(tilt) so that the axis itself comes out
/// as a line.
Circle fiber(const CircleCoordinates& base, const Vector& outward, double tilt) {
  const auto [sine, cosine] = elementary::sincos_turns(tilt);
  const Vector normal = cosine * base.normal - sine * cross(base.normal, outward);
  const double r = base.radius;
  const Generator dual{cosine * normal, (-r * sine) * cross(outward, normal), 0, (0.5 * r * r * cosine) * normal};
  return {seen_from(dual, -to_vector(base.center))};
}

struct HopfInputs {
  double theta, latitude;
  HopfMethod method;
};

Attempt<Circle> hopf_fiber(const Circle& shape, const HopfInputs& in) {
  const std::optional<CircleCoordinates> base = coordinates(shape);
  if (!base || base->line || base->radius == 0) {
    return Failure{"degenerate", "the base must be a circle with a radius, so that it has an axis", "shape"};
  }
  const Vector start = any_perpendicular(base->normal);
  const auto [sine, cosine] = elementary::sincos_turns(in.theta);
  const Vector outward = cosine * start + sine * cross(base->normal, start);
  if (in.method == HopfMethod::exact) return fiber(*base, outward, 0.25 * in.latitude);
  const Generator tangent = null_pair(base->center, outward / base->radius);
  const Circle straight = apply(exponential(tangent), shape);
  const std::optional<Versor> motor = motor_between(straight, line_from(base->center, base->normal));
  const std::optional<Generator> twist = motor ? motor_logarithm(*motor) : std::nullopt;
  if (!twist) return Failure{"degenerate", "the boosted base is no line", "shape"};
  return apply(compose(exponential(in.latitude * *twist), exponential(in.latitude * tangent)), shape);
}

}  // namespace

void add_operators(Registry& registry) {
  registry.add(
      VersorNode<loxodrome>::declare("loxodrome")
          .title("Loxodrome")
          .family("transforms")
          .synonyms({"spiral", "rhumb", "helix"})
          .doc("A boost at the origin and a translation in one exponential: exp(amount (lambda no^a + gamma b^ni)).")
          .source("Boosted Surfaces, section 3, fig. 3")
          .details("The generator is simple, and both rules agree, only when a and b are parallel.")
          .degenerate("zero direction", "A zero vector leaves out its part; without both it is the identity.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("a", &LoxodromeInputs::a, "Direction of the boost.",
                 defaults({1, 0, 0}).direction_handle().title("Boost direction"))
          .input("lambda", &LoxodromeInputs::lambda, "Strength of the boost.",
                 defaults(1).hard(-1e6, 1e6).soft(-4, 4).unit("1/m").title("Boost strength"))
          .input("b", &LoxodromeInputs::b, "Direction of the translation.",
                 defaults({0, 1, 0}).direction_handle().title("Travel direction"))
          .input("gamma", &LoxodromeInputs::gamma, "Strength of the translation.",
                 defaults(1).hard(-1e6, 1e6).soft(-4, 4).unit("m").title("Travel strength"))
          .input("amount", &LoxodromeInputs::amount, "How far along the loxodrome.", defaults(1).soft(-4, 4))
          .input("rule", &LoxodromeInputs::rule,
                 "The true exponential, or the paper's with the scalar part of the square only.",
                 defaults("exact").title("Exponential"))
          .output("shape", "The transformed shape."));

  registry.add(
      VersorNode<product_of_points>::declare("product")
          .title("Product of points")
          .family("transforms")
          .synonyms({"rotor", "geometric product", "two points"})
          .doc("Applies the geometric product of two weighted points, with its bivector part scaled by an amount.")
          .source("Boosted Surfaces, eq. (20), fig. 16")
          .details("K = <ab>_0 + amount <ab>_2; each weight replaces the no coefficient of its point. Where K ~K = 0 "
                   "everything "
                   "collapses to one point. K = 0 is an error.")
          .degenerate("coincident points", "Equal weights 1 give K = 0: an error.")
          .degenerate("w = -1",
                      "With both weights -1 the scalar part of a unit pair about the origin is 0: every amount gives "
                      "the same map, and amount 0, where K = 0, is an error.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("a", &ProductInputs::a, "First point.",
                 defaults({0, 0, 1}).unit("m").position_handle().title("First point"))
          .input("weight_a", &ProductInputs::weight_a, "Weight of its no coefficient.",
                 defaults(1).hard(-1e6, 1e6).soft(-1, 1).title("First weight"))
          .input("b", &ProductInputs::b, "Second point.",
                 defaults({0, 0, -1}).unit("m").position_handle().title("Second point"))
          .input("weight_b", &ProductInputs::weight_b, "Weight of its no coefficient.",
                 defaults(1).hard(-1e6, 1e6).soft(-1, 1).title("Second weight"))
          .input("amount", &ProductInputs::amount, "Factor of the bivector part.",
                 defaults(0.5).hard(-1e6, 1e6).soft(-1, 1))
          .output("shape", "The transformed shape."));

  registry.add(
      VersorNode<sphere_to_sphere>::declare("boost_between")
          .title("Boost between")
          .family("transforms")
          .synonyms({"morph", "sphere to sphere", "inversion", "align"})
          .doc("Applies a power of the simple rotor that takes one sphere or plane to another.")
          .source("Colapinto, Composing Surfaces with Conformal Rotors, AACA 27 (2017)")
          .details(
              "Orientation does not count: the nearer of the two ways is taken. Equal spheres give the identity. "
              "Between "
              "two spheres that lie apart the way goes through infinity: near the middle of it shapes are large, and "
              "then inside out.")
          .degenerate("zero radius", "A sphere of radius zero has no inverse: an error.")
          .degenerate("parallel lines", "Parallel planes give a translation.")
          .degenerate("opposite lines",
                      "Orientation does not count: opposite planes give what equally oriented ones give.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("from", &BoostBetweenInputs::from, "The sphere that is moved.")
          .input("to", &BoostBetweenInputs::to, "The sphere that it is moved to.")
          .input("amount", &BoostBetweenInputs::amount, "0 nothing, 1 the whole way.",
                 defaults(1).hard(-1e6, 1e6).soft(0, 1))
          .output("shape", "The moved shape."));

  registry.add(
      node("hopf", hopf_fiber)
          .title("Hopf fiber")
          .family("transforms")
          .synonyms({"linked circles", "fibration", "villarceau", "bundle"})
          .doc("A base circle boosted towards a line and twisted towards its axis: one fiber of a bundle of "
               "linked circles.")
          .source("Boosted Surfaces, eqs. (9), (10), (11), (12), figs. 6, 7")
          .details("For a base of radius 1 the squared radius less the squared distance of the center is 1 "
                   "for every fiber of the exact method, as in the Hopf fibration, and 1 - latitude^2/4 for "
                   "the paper's. Latitude 0 is the base, 1 its axis.")
          .degenerate("circle to line", "Latitude 1 is the axis, a line; a line as the base is an error.")
          .degenerate("zero radius", "An error: the base has no size to measure by.")
          .input("shape", "The base circle.", required().title("Base circle"))
          .input("theta", &HopfInputs::theta, "Longitude; 1 is once around.",
                 defaults(0).soft(0, 1).unit("turn").title("Longitude"))
          .input("latitude", &HopfInputs::latitude, "From the base circle to its axis: the paper's 1/2 + phi/pi.",
                 defaults(0.5).hard(0, 1).soft(0, 1))
          .input("method", &HopfInputs::method, "True Hopf fibers, or the paper's boost and twist.", defaults("exact"))
          .output("circle", "The fiber."));
}

}  // namespace dini
