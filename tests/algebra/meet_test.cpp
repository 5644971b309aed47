#include "algebra/meet.h"

#include <catch2/catch.hpp>

#include "algebra/extract.h"
#include "algebra/relation.h"
#include "algebra/versor.h"
#include "tests/algebra/round_or_flat.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("Points of a meet lie on both, and there are none exactly where spheres are apart") {
  RandomElements random(11);
  int crossing = 0, apart = 0;
  for (int i = 0; i < 600; ++i) {
    const Sphere a = sphere_or_plane(random, i), b = sphere_or_plane(random, i / 3);
    const auto found = meet(a, b);
    REQUIRE(found);
    if (found->kind == Meeting::apart) {
      ++apart;
      CHECK(found->a == Point::at_infinity());
      CHECK(coordinates(found->circle)->radius == 0);
      CHECK(*least_distance(a, b) > 0);
      continue;
    }
    ++crossing;
    CHECK(*least_distance(a, b) == 0);
    const auto circle = coordinates(found->circle);
    REQUIRE(circle);
    for (const double turn : {0.0, 0.2, 0.45}) {
      const Point on = point_at(*circle, turn);
      const double size = 1e-12 * (1 + length(to_vector(on)) * length(to_vector(on)));
      CHECK(*least_distance(a, on) <= size);
      CHECK(*least_distance(b, on) <= size);
    }
    CHECK(*least_distance(found->circle, found->a) <= 1e-12);
  }
  CHECK(crossing > 100);
  CHECK(apart > 100);
}

TEST_CASE("The two points where a circle meets a sphere lie on both, and their pair has them as its ends") {
  RandomElements random(12);
  int crossing = 0, apart = 0;
  for (int i = 0; i < 600; ++i) {
    const Circle circle = circle_or_line(random, i, 4);
    const Sphere sphere = sphere_or_plane(random, i);
    const auto found = meet(circle, sphere);
    REQUIRE(found);
    if (found->kind == Meeting::apart) {
      ++apart;
      CHECK(*least_distance(circle, sphere) > 0);
      continue;
    }
    ++crossing;
    CHECK(*least_distance(circle, sphere) <= 1e-14);
    for (const Point& p : {found->a, found->b}) {
      if (!is_finite(p)) continue;
      const double size = 1e-12 * (1 + length(to_vector(p)) * length(to_vector(p)));
      CHECK(*least_distance(circle, p) <= size);
      CHECK(*least_distance(sphere, p) <= size);
    }
    // exp of a real pair keeps its own ends
    const auto kept = apply(exponential(0.3 * found->pair), found->a);
    REQUIRE(kept);
    require_close(*kept, found->a, 1e-9);
  }
  CHECK(crossing > 100);
  CHECK(apart > 100);
}

TEST_CASE("A circle leaves a sphere at a and enters it at b") {
  RandomElements random(13);
  for (int i = 0; i < 200; ++i) {
    const Circle circle = circle_from(random.point(), random.vector(), 1);
    const auto along = coordinates(circle);
    const Sphere sphere = i % 2 == 0 ? sphere_from(random.point(), 1) : plane_from(random.point(0.3), random.vector());
    const auto found = meet(circle, sphere);
    REQUIRE(found);
    if (found->kind != Meeting::crossing || distance(found->a, found->b) < 0.1) continue;
    // The value of the sphere's function, above zero within it, a little ahead of each.
    const auto ahead = [&](const Point& p) {
      const Vector out = (to_vector(p) - to_vector(along->center)) / along->radius;
      const Vector there = to_vector(p) + 1e-4 * cross(along->normal, out);
      return dot(sphere.e, there) - 0.5 * sphere.no * squared_length(there) - sphere.ni;
    };
    CHECK(ahead(found->a) < 0);
    CHECK(ahead(found->b) > 0);
  }
}

TEST_CASE("What touches is told from what crosses and what is apart") {
  const Sphere unit = sphere_from({0, 0, 0}, 1);
  const auto kind = [](const auto& found) { return static_cast<int>(found->kind); };
  for (const double size : {1.0, 1e-3, 1e3}) {
    const Sphere ball = sphere_from({0, 0, 0}, size), beside = sphere_from({2 * size, 0, 0}, size);
    CHECK(kind(meet(ball, beside)) == 0);
    require_close(meet(ball, beside)->a, {size, 0, 0}, 1e-14);
    CHECK(coordinates(meet(ball, beside)->circle)->radius == 0);
    CHECK(kind(meet(ball, sphere_from({2.0001 * size, 0, 0}, size))) == -1);
    CHECK(kind(meet(ball, sphere_from({1.9999 * size, 0, 0}, size))) == 1);
    CHECK(kind(meet(ball, sphere_from({0.25 * size, 0, 0}, 0.75 * size))) == 0);
    CHECK(kind(meet(ball, sphere_from({0.25 * size, 0, 0}, 0.5 * size))) == -1);
    CHECK(kind(meet(ball, plane_from({0, 0, size}, {0, 0, 1}))) == 0);
    CHECK(kind(meet(circle_from({2 * size, 0, 0}, {0, 0, 1}, size), ball)) == 0);
    CHECK(kind(meet(line_from({size, 0, 0}, {0, 1, 0}), ball)) == 0);
    CHECK(kind(meet(line_from({1.001 * size, 0, 0}, {0, 1, 0}), ball)) == -1);
  }
  CHECK(kind(meet(unit, sphere_from({0, 0, 0}, 2))) == -1);
  CHECK(kind(meet(plane_from({0, 0, 0}, {0, 0, 1}), plane_from({0, 0, 1}, {0, 0, -2}))) == 0);
  CHECK(meet(plane_from({0, 0, 0}, {0, 0, 1}), plane_from({0, 0, 1}, {0, 0, -2}))->a == Point::at_infinity());
  CHECK(kind(meet(line_from({0, 0, 1}, {1, 0, 0}), plane_from({0, 0, 0}, {0, 0, 1}))) == 0);
  CHECK(kind(meet(circle_from({0, 0, 0}, {0, 0, 1}, 2), unit)) == -1);
  // A pair that has moved out to infinity turns about the axis of the circle.
  CHECK(length(meet(circle_from({0, 0, 0}, {0, 0, 1}, 2), unit)->pair.e_e) == Approx(1));
}

TEST_CASE("One element that lies in the other meets it nowhere in particular") {
  const Sphere unit = sphere_from({1, 0, 0}, 1), plane = plane_from({0, 0, 2}, {0, 0, 1});
  CHECK_FALSE(meet(unit, unit));
  CHECK_FALSE(meet(plane, plane_from({5, 1, 2}, {0, 0, -3})));
  CHECK_FALSE(meet(circle_from({1, 0, 0}, {0, 1, 1}, 1), unit));
  CHECK_FALSE(meet(circle_from({1, 0, 2}, {0, 0, 1}, 7), plane));
  CHECK_FALSE(meet(line_from({1, 0, 2}, {1, 1, 0}), plane));
  CHECK_FALSE(meet(Circle{}, unit));
}

TEST_CASE("A line crosses a plane once more at infinity") {
  const auto found = meet(line_from({1, 2, 0}, {0, 0, 1}), plane_from({0, 0, 3}, {0, 1, 1}));
  REQUIRE(found);
  require_close(found->a, {1, 2, 1}, 1e-14);
  CHECK(found->b == Point::at_infinity());
  CHECK(found->pair.no_ni == 1);
}

TEST_CASE("The sphere through four points passes through them, also where it is a plane") {
  RandomElements random(14);
  for (int i = 0; i < 300; ++i) {
    const Point a = random.point(), b = random.point(), c = random.point();
    const Point d = i % 3 == 0 ? to_point(to_vector(a) + random.number() * (to_vector(b) - to_vector(a)) +
                                          random.number() * (to_vector(c) - to_vector(a)))
                               : random.point();
    const auto sphere = sphere_through(a, b, c, d);
    REQUIRE(sphere);
    CHECK(coordinates(*sphere)->plane == (i % 3 == 0));
    for (const Point& p : {a, b, c, d}) {
      const double radius = coordinates(*sphere)->radius;
      CHECK(*least_distance(*sphere, p) <= 1e-13 * (1 + radius));
    }
  }
}

TEST_CASE("Four points of which one is at infinity give a plane, and those of one circle give none") {
  const Point far = Point::at_infinity();
  for (const auto& sphere :
       {sphere_through({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, far), sphere_through({0, 0, 1}, {1, 0, 1}, far, {0, 1, 1}),
        sphere_through({0, 0, 1}, far, {1, 0, 1}, {0, 1, 1}), sphere_through(far, {0, 0, 1}, {1, 0, 1}, {0, 1, 1})}) {
    REQUIRE(sphere);
    const auto found = coordinates(*sphere);
    REQUIRE(found->plane);
    require_close(found->normal, {0, 0, 1}, 1e-15);
    CHECK(found->distance == Approx(1));
  }
  CHECK_FALSE(sphere_through({1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}));
  CHECK_FALSE(sphere_through({1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}));
  CHECK_FALSE(sphere_through({1, 0, 0}, {1, 0, 0}, {3, 1, 0}, {4, 0, 1}));
  CHECK_FALSE(sphere_through({1, 0, 0}, {2, 0, 0}, {3, 0, 0}, far));
  CHECK_FALSE(sphere_through({1, 0, 0}, {2, 0, 0}, far, far));
}
