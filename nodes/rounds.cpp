// Circles and spheres: made from points, and taken apart.

#include <cmath>

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "algebra/kernels.h"
#include "algebra/tolerance.h"
#include "algebra/versor.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/held_radius.h"

namespace dini {

namespace {

struct ThreePointsInputs {
  Point a, b, c;
};

Attempt<Circle> circle_of_three(const ThreePointsInputs& in) {
  const Circle circle = circle_through(in.a, in.b, in.c);
  if (!coordinates(circle))
    return Failure{"degenerate", "two of the three points agree, so many circles pass through them", "b"};
  return circle;
}

struct SphereInputs {
  Point center;
  double radius;
};

Attempt<Sphere> sphere_element(const SphereInputs& in) {
  const Sphere sphere = sphere_from(in.center, in.radius);
  if (const std::optional<SphereCoordinates> found = coordinates(sphere); !found || lost(found->radius, in.radius)) {
    return too_far_for(in.radius, in.center);
  }
  return sphere;
}

struct OsculatingSphereInputs {
  Point position;
  Vector normal;
  double curvature;
};

Attempt<Sphere> sphere_of_curvature(const OsculatingSphereInputs& in) {
  if (in.normal == Vector{}) return Failure{"degenerate", "the normal must not be zero", "normal"};
  const Generator tangent = null_pair(in.position, normalized(in.normal));
  return apply(exponential((-0.5 * in.curvature) * tangent), plane_from(in.position, in.normal));
}

Attempt<std::tuple<Circle, Vector>> axis_of_circle(const Circle& shape) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle to take the axis of", "shape"};
  if (found->line)
    return Failure{"degenerate", "a line has no axis: every circle through infinity is wider than any axis", "shape"};
  return std::tuple{line_from(found->center, found->normal), found->normal};
}

std::tuple<Point, Point> at(const Point& center, const Vector& half) {
  return {to_point(to_vector(center) + half), to_point(to_vector(center) - half)};
}

Attempt<std::tuple<Point, Point>> poles_of_circle(const Circle& shape) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle to take the poles of", "shape"};
  if (found->line)
    return Failure{"degenerate", "the poles of a line are both at infinity, in no particular direction", "shape"};
  return at(found->center, found->radius * found->normal);
}

Attempt<std::tuple<Point, Point>> poles_of_pair(const Generator& shape) {
  const auto& [tangent, moment, slope, rest] = shape;
  const Point middle = kernels::warp_source(shape).position;
  const double weight = squared_length(tangent);
  if (weight == 0) {
    if (slope != 0) return std::tuple{middle, Point::at_infinity()};
    return Failure{"degenerate", "the generator is no point pair", "shape"};
  }
  // B.B = r^2 |no_e|^2, r half the distance of the poles.
  const double positive = slope * slope, negative = squared_length(moment), along = 2 * dot(tangent, rest);
  const double square = positive - negative - along;
  const double noise = tolerance::square_noise * (positive + negative + std::abs(along));
  if (square < -noise) return Failure{"degenerate", "the point pair is imaginary, it has no poles in space", "shape"};
  return at(middle, (square > noise ? std::sqrt(square) / weight : 0.0) * tangent);
}

Attempt<Point> center_of_circle(const Circle& shape) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle to take the center of", "shape"};
  return found->line ? Point::at_infinity() : found->center;
}

Attempt<Point> center_of_sphere(const Sphere& shape) {
  const std::optional<SphereCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no sphere to take the center of", "shape"};
  return found->plane ? Point::at_infinity() : found->center;
}

Attempt<Point> center_of_generator(const Generator& shape) {
  if (shape == Generator{}) return Failure{"degenerate", "the zero generator sits nowhere", "shape"};
  if (shape.no_e == Vector{} && shape.e_e == Vector{} && shape.no_ni == 0) return Point::at_infinity();
  return kernels::warp_source(shape).position;
}

Attempt<double> radius_of_circle(const Circle& shape) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle to take the radius of", "shape"};
  if (found->line) return Failure{"degenerate", "a line has no finite radius", "shape"};
  return found->radius;
}

Attempt<double> radius_of_sphere(const Sphere& shape) {
  const std::optional<SphereCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no sphere to take the radius of", "shape"};
  if (found->plane) return Failure{"degenerate", "a plane has no finite radius", "shape"};
  return found->radius;
}

}  // namespace

void add_rounds(Registry& registry) {
  registry.add(node("circle_through", circle_of_three)
                   .title("Circle through three points")
                   .family("elements")
                   .synonyms({"three points", "arc", "circumcircle", "ring"})
                   .doc("The circle through three points, run from a over b to c.")

                   .degenerate("circle to line", "Collinear points, or one at infinity, give the line.")
                   .degenerate("coincident points", "An error: many circles pass through two points.")
                   .input("a", &ThreePointsInputs::a, "First point.",
                          defaults({1, 0, 0}).unit("m").position_handle().title("First point"))
                   .input("b", &ThreePointsInputs::b, "Second point.",
                          defaults({0, 1, 0}).unit("m").position_handle().title("Second point"))
                   .input("c", &ThreePointsInputs::c, "Third point.",
                          defaults({-1, 0, 0}).unit("m").position_handle().title("Third point"))
                   .output("circle", "The circle, or the line."));

  registry.add(
      node("sphere", sphere_element)
          .title("Sphere")
          .family("elements")
          .synonyms({"ball", "globe", "round"})
          .doc("An oriented sphere as an element; transforms carry it, also into planes.")
          .details(
              "To draw one, see sphere mesh. A radius below a few ten-millionths of the distance from the origin is "
              "lost in round-off and an error.")
          .degenerate("zero radius", "The point sphere at the center.")
          .input("center", &SphereInputs::center, "Its center.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("radius", &SphereInputs::radius, "Its radius.",
                 defaults(1).hard(0, 1e9).soft(0, 4).unit("m").radius_handle("center"))
          .output("sphere", "The sphere."));

  registry.add(node("osculating_sphere", sphere_of_curvature)
                   .title("Osculating sphere")
                   .family("elements")
                   .synonyms({"tangent sphere", "touching", "ball"})
                   .doc("The sphere of a given curvature through a point: a plane bent by the boost of its own normal.")
                   .source("Colapinto, Composing Surfaces with Conformal Rotors, AACA 27 (2017)")
                   .details("Its center is at position - normal / curvature; curvature 0 gives the plane.")
                   .degenerate("zero direction", "A zero normal is an error.")
                   .input("position", &OsculatingSphereInputs::position, "Where it touches.",
                          defaults({0, 0, 0}).unit("m").position_handle())
                   .input("normal", &OsculatingSphereInputs::normal, "Normal of the plane, of any length.",
                          defaults({0, 0, 1}).direction_handle("position"))
                   .input("curvature", &OsculatingSphereInputs::curvature,
                          "One over the radius; above 0 the center is against the normal, below 0 along it.",
                          defaults(1).hard(-1e9, 1e9).soft(-4, 4).unit("1/m"))
                   .output("sphere", "The sphere, or the plane."));

  registry.add(node("axis_of", axis_of_circle)
                   .title("Axis of")
                   .family("elements")
                   .synonyms({"center line", "normal line"})
                   .doc("The line through the center of a circle along its normal.")
                   .source("Boosted Surfaces, eqs. (6), (7), (8)")
                   .details("The axis runs along the normal, about which the circle runs counter-clockwise.")
                   .degenerate("circle to line", "A line has no axis: an error.")
                   .degenerate("zero radius", "The axis along the normal that the circle has kept.")
                   .input("shape", "The circle.")
                   .output("axis", "The axis, a line.")
                   .output("direction", "The unit normal."));

  registry.add(
      node("poles_of", poles_of_circle, poles_of_pair)
          .title("Poles of")
          .family("elements")
          .synonyms({"ends", "points of", "tips", "endpoints"})
          .doc("The two poles of a circle, of which it is the equator; or the two points of a point pair.")
          .source("Boosted Surfaces, section 6, fig. 16")
          .details("A circle of radius zero and a null pair have both poles in one point; a flat point has "
                   "one at infinity. A "
                   "line, an imaginary pair and a generator that is no pair are errors.")
          .degenerate("circle to line", "The poles of a line are at infinity, in no particular direction: an error.")
          .degenerate("zero radius", "Both poles are the center; those of a null pair are its point.")
          .input("shape", "A circle or a point pair.")
          .output("a", "The pole at center + radius * normal, or ahead along the tangent.")
          .output("b", "The other pole."));

  registry.add(node("center_of", center_of_circle, center_of_sphere, center_of_generator)
                   .title("Center of")
                   .family("elements")
                   .synonyms({"midpoint", "middle", "centroid", "position of"})
                   .doc("The center of a circle or sphere, or the place where a generator sits.")
                   .details("Lines, planes and directions have theirs at infinity. A rotation sits at the point of its "
                            "axis nearest the origin.")
                   .degenerate("circle to line", "The point at infinity, as for planes and directions.")
                   .degenerate("zero radius", "The center.")
                   .degenerate("zero direction", "The zero generator sits nowhere: an error.")
                   .input("shape", "A circle, sphere or generator.")
                   .output("point", "The center."));

  registry.add(node("radius_of", radius_of_circle, radius_of_sphere)
                   .title("Radius of")
                   .family("elements")
                   .synonyms({"size of", "length", "distance"})
                   .doc("The radius of a circle or sphere.")

                   .degenerate("circle to line", "A line, or a plane, has no finite radius: an error.")
                   .degenerate("zero radius", "0.")
                   .input("shape", "A circle or sphere.")
                   .output("radius", "The radius, in meters."));
}

}  // namespace dini
