#include "algebra/relation.h"

#include <catch2/catch.hpp>

#include "algebra/extract.h"
#include "algebra/meet.h"
#include "algebra/versor.h"
#include "tests/algebra/round_or_flat.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Many points of a circle, or of a piece of a line.
std::vector<Point> points_of(const Circle& circle) {
  const auto found = coordinates(circle);
  std::vector<Point> points;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) points.push_back(point_at(*found, static_cast<double>(i) / count - 0.5, 40));
  return points;
}

}  // namespace

TEST_CASE("The nearest point lies on the element, and no other of its points is nearer") {
  RandomElements random(21);
  for (int i = 0; i < 40; ++i) {
    const Circle circle = circle_or_line(random, i, 3);
    const Sphere sphere = sphere_or_plane(random, i);
    const Point p = random.point(2);
    const Point on_circle = *nearest_point(circle, p), on_sphere = *nearest_point(sphere, p);
    CHECK(*least_distance(circle, on_circle) < 1e-14);
    CHECK(*least_distance(sphere, on_sphere) < 1e-14);
    CHECK(distance(on_circle, p) == Approx(*least_distance(circle, p)).margin(1e-14));
    CHECK(distance(on_sphere, p) == Approx(*least_distance(sphere, p)).margin(1e-14));
    for (const Point& other : points_of(circle)) REQUIRE(distance(other, p) >= distance(on_circle, p) - 1e-14);
  }
}

TEST_CASE("Points without a nearest point get one by a fixed rule") {
  const Circle circle = circle_from({1, 2, 3}, {0, 0, 1}, 2);
  const Point start = point_at(*coordinates(circle), 0);
  require_close(*nearest_point(circle, {1, 2, 9}), start, 1e-15);
  require_close(*nearest_point(circle, Point::at_infinity()), start, 1e-15);
  require_close(*nearest_point(sphere_from({1, 2, 3}, 2), {1, 2, 3}), {1, 2, 5}, 1e-15);
  CHECK(*nearest_point(line_from({1, 2, 3}, {1, 0, 0}), Point::at_infinity()) == Point::at_infinity());
  CHECK_FALSE(nearest_point(Circle{}, Point{}));
  CHECK_FALSE(least_distance(circle, Point::at_infinity()));
  CHECK(least_distance(plane_from({}, {0, 0, 1}), Point::at_infinity()) == 0.0);
}

TEST_CASE("The least distance of a circle from another element is that of its nearest point") {
  RandomElements random(22);
  for (int i = 0; i < 30; ++i) {
    const Circle circle = circle_from(random.point(), random.vector(), 0.2 + std::abs(random.number()));
    const Circle other = circle_or_line(random, i, 3);
    const Sphere sphere = sphere_or_plane(random, i);
    double to_circle = 1e9, to_sphere = 1e9;
    for (const Point& p : points_of(circle)) {
      to_circle = std::min(to_circle, *least_distance(other, p));
      to_sphere = std::min(to_sphere, *least_distance(sphere, p));
    }
    const double found = *least_distance(circle, other);
    CHECK(found <= to_circle);
    CHECK(found >= to_circle - 2e-3);
    CHECK(*least_distance(other, circle) == Approx(found).margin(1e-12));
    CHECK(*least_distance(circle, sphere) <= to_sphere);
    CHECK(*least_distance(circle, sphere) >= to_sphere - 2e-3);
  }
}

TEST_CASE("Distances of spheres, planes and lines are those of school") {
  CHECK(*least_distance(sphere_from({0, 0, 0}, 1), sphere_from({4, 0, 0}, 2)) == Approx(1));
  CHECK(*least_distance(sphere_from({0, 0, 0}, 4), sphere_from({1, 0, 0}, 2)) == Approx(1));
  CHECK(*least_distance(sphere_from({0, 0, 0}, 1), sphere_from({1, 0, 0}, 1)) == 0);
  CHECK(*least_distance(plane_from({0, 0, 1}, {0, 0, 1}), plane_from({0, 0, 4}, {0, 0, -1})) == Approx(3));
  CHECK(*least_distance(plane_from({0, 0, 1}, {0, 0, 1}), plane_from({0, 0, 4}, {0, 1, -1})) == 0);
  CHECK(*least_distance(sphere_from({0, 0, 5}, 1), plane_from({0, 0, 1}, {0, 0, 1})) == Approx(3));
  CHECK(*least_distance(line_from({0, 0, 0}, {1, 0, 0}), line_from({0, 3, 2}, {0, 1, 0})) == Approx(2));
  CHECK(*least_distance(line_from({0, 0, 0}, {1, 0, 0}), line_from({9, 3, 4}, {-1, 0, 0})) == Approx(5));
  CHECK(*least_distance(line_from({0, 0, 3}, {1, 0, 0}), sphere_from({7, 0, 0}, 1)) == Approx(2));
  CHECK(*least_distance(line_from({0, 0, 3}, {1, 0, 0}), plane_from({0, 0, 1}, {0, 0, 1})) == Approx(2));
  CHECK(*least_distance(circle_from({0, 0, 0}, {0, 0, 1}, 1), circle_from({0, 0, 0}, {0, 0, 1}, 3)) == Approx(2));
  CHECK(*least_distance(circle_from({0, 0, 0}, {0, 0, 1}, 1), circle_from({1, 0, 0}, {0, 1, 0}, 1)) ==
        Approx(1).epsilon(1e-9));
}

TEST_CASE("Angles are the same under every conformal map") {
  RandomElements random(23);
  for (int i = 0; i < 200; ++i) {
    const Versor v = exponential(random.generator(0.25));
    const Circle c = circle_or_line(random, i, 3), d = circle_or_line(random, i / 3, 3);
    const Sphere s = sphere_or_plane(random, i), t = sphere_or_plane(random, i / 3);
    CHECK(*angle_cosine(apply(v, c), apply(v, d)) == Approx(*angle_cosine(c, d)).margin(1e-9));
    CHECK(*angle_cosine(apply(v, c), apply(v, s)) == Approx(*angle_cosine(c, s)).margin(1e-9));
    // Spheres whose inside has become the outside meet at the other angle.
    CHECK(std::abs(*angle_cosine(apply(v, s), apply(v, t))) == Approx(std::abs(*angle_cosine(s, t))).margin(1e-9));
  }
}

TEST_CASE("Angles are those of tangents and normals where elements meet") {
  RandomElements random(24);
  for (int i = 0; i < 200; ++i) {
    const Circle circle = circle_from(random.point(), random.vector(), 1);
    const auto along = coordinates(circle);
    const Sphere sphere = sphere_from(random.point(), 1);
    const auto met = meet(circle, sphere);
    REQUIRE(met);
    const double cosine = *angle_cosine(circle, sphere);
    CHECK((cosine <= 1) == (met->kind != Meeting::apart));
    if (met->kind != Meeting::crossing) continue;
    const Vector tangent = cross(along->normal, to_vector(met->a) - to_vector(along->center));
    const Vector normal = to_vector(met->a) - to_vector(coordinates(sphere)->center);
    CHECK(dot(tangent, normal) * dot(tangent, normal) == Approx(1 - cosine * cosine).margin(1e-9));
    // Two circles through one point, the second along the normal there.
    const Circle other = circle_from(to_point(to_vector(met->a) + any_perpendicular(normal)),
                                     cross(any_perpendicular(normal), normal), 1);
    const Vector other_tangent =
        cross(normalized(cross(any_perpendicular(normal), normal)), -any_perpendicular(normal));
    CHECK(*angle_cosine(circle, other) == Approx(dot(tangent, other_tangent)).margin(1e-9));
  }
  CHECK(*angle_cosine(sphere_from({0, 0, 0}, 1), sphere_from({2, 0, 0}, 1)) == Approx(-1));
  CHECK(*angle_cosine(sphere_from({0, 0, 0}, 3), sphere_from({4, 0, 0}, 5)) == Approx(0.6));
  CHECK(*angle_cosine(line_from({}, {1, 0, 0}), plane_from({}, {0, 0, 1})) == Approx(1));
  CHECK_FALSE(angle_cosine(sphere_from({0, 0, 0}, 0), sphere_from({2, 0, 0}, 1)));
}
