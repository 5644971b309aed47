// Elements seen together: where they meet, how far they are from each other and at which angle they cross.

#include <algorithm>
#include <cmath>

#include "algebra/elementary.h"
#include "algebra/extract.h"
#include "algebra/meet.h"
#include "algebra/relation.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

constexpr double degrees_per_radian = 180 / 3.14159265358979323846;

template <class Element>
bool is_element(const Element& element) {
  return coordinates(element).has_value();
}
bool is_element(const Point& point) { return is_finite(point); }

Failure no_element(const char* port) {
  return {"degenerate", "there is no such circle or sphere, or the point is at infinity", port};
}

struct MeetInputs {
  Sphere sphere;
};

template <class Element>
std::optional<Failure> fault_of(const Element& shape, const MeetInputs& in) {
  if (!is_element(shape)) return no_element("shape");
  if (!is_element(in.sphere)) return no_element("sphere");
  return std::nullopt;
}

constexpr const char* in_one_another = "the one lies in the other, so they meet everywhere";

Attempt<std::tuple<Circle, Point, Point, double>> spheres_met(const Sphere& shape, const MeetInputs& in) {
  if (std::optional<Failure> fault = fault_of(shape, in)) return *fault;
  const std::optional<SphereMeeting> found = meet(shape, in.sphere);
  if (!found) return Failure{"degenerate", in_one_another, "sphere"};
  return std::tuple{found->circle, found->a, found->b, static_cast<double>(found->kind)};
}

Attempt<std::tuple<Generator, Point, Point, double>> circle_met(const Circle& shape, const MeetInputs& in) {
  if (std::optional<Failure> fault = fault_of(shape, in)) return *fault;
  const std::optional<CircleMeeting> found = meet(shape, in.sphere);
  if (!found) return Failure{"degenerate", in_one_another, "sphere"};
  return std::tuple{found->pair, found->a, found->b, static_cast<double>(found->kind)};
}

struct FourPointsInputs {
  Point a, b, c, d;
};

Attempt<Sphere> sphere_of_four(const FourPointsInputs& in) {
  if (const std::optional<Sphere> sphere = sphere_through(in.a, in.b, in.c, in.d)) return *sphere;
  return Failure{"degenerate", "the four points agree in two, or lie on one circle, so many spheres pass through them",
                 "d"};
}

struct ProjectInputs {
  Point point;
};

template <class Element>
Attempt<std::tuple<Point, double>> projected(const Element& shape, const ProjectInputs& in) {
  const std::optional<Point> nearest = nearest_point(shape, in.point);
  if (!nearest) return no_element("shape");
  const std::optional<double> distance = least_distance(shape, in.point);
  if (!distance) return no_element("point");
  return std::tuple{*nearest, *distance};
}

template <class Element>
struct OtherInputs {
  Element other;
};

template <class Element, class Other>
Attempt<double> distance_between(const Element& shape, const OtherInputs<Other>& in) {
  std::optional<double> distance;
  if constexpr (requires { least_distance(shape, in.other); }) {
    distance = least_distance(shape, in.other);
  } else {
    distance = least_distance(in.other, shape);
  }
  if (distance) return *distance;
  return no_element(is_element(shape) ? "other" : "shape");
}

template <class Element, class Other>
Attempt<std::tuple<double, double>> angle_between(const Element& shape, const OtherInputs<Other>& in) {
  std::optional<double> cosine;
  if constexpr (requires { angle_cosine(shape, in.other); }) {
    cosine = angle_cosine(shape, in.other);
  } else {
    cosine = angle_cosine(in.other, shape);
  }
  if (!cosine) {
    const auto found = coordinates(shape);
    const bool is_right = found && (found->radius > 0 || angle_cosine(shape, shape));
    return Failure{"degenerate", "an angle needs circles and spheres with a radius", is_right ? "other" : "shape"};
  }
  const double angle = elementary::acos(std::clamp(*cosine, -1.0, 1.0)) * degrees_per_radian;
  return std::tuple{angle, *cosine};
}

}  // namespace

void add_relations(Registry& registry) {
  registry.add(
      node("meet", spheres_met, circle_met)
          .title("Meet")
          .family("elements")
          .synonyms({"intersection", "intersect", "cut", "section"})
          .doc("What a sphere or plane has in common with another one, or with a circle or line.")
          .source("Dorst, Fontijne and Mann, Geometric Algebra for Computer Science (2007), chapter 14")
          .details("Two spheres meet in a circle, planes in a line, a circle and a sphere in a pair of points, a line "
                   "and a plane in a point and infinity. kind is 1 where they cross, 0 where they touch (to "
                   "round-off), -1 where they are apart: then the circle has radius zero, the pair is imaginary, and "
                   "a and b are at infinity. Parallel planes, or a plane and a line along it, touch at "
                   "infinity. One that lies in the other is an error.")
          .degenerate("parallel lines", "Planes and lines that are parallel touch at infinity, kind 0.")
          .degenerate("zero radius", "A point is met where it lies on the other: kind 0, else -1.")
          .input("shape", "A sphere, plane, circle or line.")
          .input("sphere", &MeetInputs::sphere, "The other sphere or plane.", required().title("Sphere or plane"))
          .output("shape", "The circle or line; of a circle or line, the point pair.")
          .output("a",
                  "The point where a circle leaves the sphere, or the side that a normal points to; of two "
                  "spheres, the start of their circle.")
          .output("b", "The point where a circle enters; of two spheres, the point opposite to a.")
          .output("kind", "1 they cross, 0 they touch, -1 they are apart."));

  registry.add(node("sphere_through", sphere_of_four)
                   .title("Sphere through four points")
                   .family("elements")
                   .synonyms({"circumsphere", "plane through three points"})
                   .doc("The sphere, or the plane, through four points.")
                   .details("Four points of a plane, or three and one at infinity, give the plane; its normal is that "
                            "of a, b, c run counter-clockwise.")
                   .degenerate("coincident points",
                               "Two that agree, or four on one circle or line, are an error: many "
                               "spheres pass through them.")
                   .input("a", &FourPointsInputs::a, "First point.",
                          defaults({1, 0, 0}).unit("m").title("First point").position_handle())
                   .input("b", &FourPointsInputs::b, "Second point.",
                          defaults({0, 1, 0}).unit("m").title("Second point").position_handle())
                   .input("c", &FourPointsInputs::c, "Third point.",
                          defaults({-1, 0, 0}).unit("m").title("Third point").position_handle())
                   .input("d", &FourPointsInputs::d, "Fourth point.",
                          defaults({0, 0, 1}).unit("m").title("Fourth point").position_handle())
                   .output("sphere", "The sphere, or the plane."));

  registry.add(
      node("project", projected<Circle>, projected<Sphere>)
          .title("Project")
          .family("elements")
          .synonyms({"nearest point", "closest point", "drop", "snap"})
          .doc("The point of a circle, line, sphere or plane nearest to a point.")
          .details("Of a point on the axis of a circle all are as near: it gives the one where sample starts; for the "
                   "center of a sphere the one above it. Only lines and planes hold the point at infinity.")
          .degenerate("zero radius", "The center.")
          .input("shape", "A circle, line, sphere or plane.")
          .input("point", &ProjectInputs::point, "The point.",
                 defaults({0, 0, 0}).unit("m").title("Point").position_handle())
          .output("point", "The nearest point.")
          .output("distance", "How far it is, in meters."));

  registry.add(
      node("distance", distance_between<Point, Point>, distance_between<Point, Circle>, distance_between<Point, Sphere>,
           distance_between<Circle, Point>, distance_between<Circle, Circle>, distance_between<Circle, Sphere>,
           distance_between<Sphere, Point>, distance_between<Sphere, Circle>, distance_between<Sphere, Sphere>)
          .title("Distance")
          .family("elements")
          .synonyms({"gap", "how far", "length between"})
          .doc("The least distance of two points, circles, lines, spheres or planes.")
          .details("0 where they meet; spheres are surfaces. Between a circle and another circle or a line it is "
                   "searched, and right to about 1e-8 of their size.")
          .degenerate("parallel lines", "Their distance, the same everywhere.")
          .degenerate("zero radius", "The distance of the center.")
          .input("shape", "A point, circle, line, sphere or plane.")
          .input("other", &OtherInputs<Point>::other, &OtherInputs<Circle>::other, &OtherInputs<Sphere>::other,
                 "The other one.", required().title("Other"))
          .output("distance", "In meters."));

  registry.add(
      node("angle", angle_between<Circle, Circle>, angle_between<Circle, Sphere>, angle_between<Sphere, Circle>,
           angle_between<Sphere, Sphere>)
          .title("Angle")
          .family("elements")
          .synonyms({"cosine", "crossing", "inversive distance"})
          .doc("The angle at which circles, lines, spheres and planes meet.")
          .details("Between spheres and planes it is that of their normals (those of spheres outward), between "
                   "circles and lines that of the directions in which they run, and between a circle and a "
                   "sphere that with its tangent plane, 0 to 90 degrees. It is the same under every "
                   "transform. Where they do not meet the cosine is beyond 1 or -1, and the angle 0 or 180.")
          .degenerate("zero radius", "An error: points cross nothing.")
          .degenerate("parallel lines", "0 degrees, or 180 where they run against each other.")
          .input("shape", "A circle, line, sphere or plane.")
          .input("other", &OtherInputs<Circle>::other, &OtherInputs<Sphere>::other, "The other one.",
                 required().title("Other"))
          .output("angle", "In degrees, 0 to 180.")
          .output("cosine", "Its cosine; beyond 1 or -1 where they do not meet."));
}

}  // namespace dini
