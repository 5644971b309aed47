#include "algebra/reflection.h"

#include <catch2/catch.hpp>

#include "algebra/extract.h"
#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/dense.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

/// Planes and spheres, small and wide, near and off the origin.
Sphere mirror_of(RandomElements& random, int i) {
  if (i % 3 == 0) return plane_from(random.point(), random.vector());
  if (i % 3 == 1) return sphere_from(random.point(), 0.2 + std::abs(random.number()));
  return sphere_from(to_point(1e4 * normalized(random.vector())), 1e4);
}

/// The plain product -s x s / s^2.
dense::Multivector<double> reflected(const Sphere& mirror, const dense::Multivector<double>& x) {
  const auto s = dense::from<double>(mirror);
  return (-1 / (s * s).c[0]) * (s * x * s);
}

}  // namespace

TEST_CASE("Reflections of points are those of the 32-coefficient algebra") {
  RandomElements random(1);
  for (int i = 0; i < 300; ++i) {
    const Sphere mirror = mirror_of(random, i);
    const Point p = random.point(2);
    const auto expected = dense::center(reflected(mirror, dense::point(p.x, p.y, p.z)));
    // The plain product loses the digits that a far center takes.
    require_close(reflect(mirror, p), {expected[0], expected[1], expected[2]}, i % 3 == 2 ? 1e-6 : 1e-10);
  }
}

TEST_CASE("Reflecting twice is the identity, for every kind of element") {
  RandomElements random(2);
  for (int i = 0; i < 300; ++i) {
    const Sphere mirror = i % 2 == 0 ? plane_from(random.point(), random.vector())
                                     : sphere_from(random.point(), 0.5 + std::abs(random.number()));
    const Point p = random.point(2);
    const Point image = reflect(mirror, p);
    // What is magnified on the way loses as many digits.
    const double size = std::max(1.0, length(to_vector(image)));
    require_close(reflect(mirror, image), p, 1e-12 * size);
    const Generator b = random.generator();
    require_close(reflect(mirror, reflect(mirror, b)), b, 2e-12);
    const Circle circle = circle_from(random.point(), random.vector(), 0.5 + std::abs(random.number()));
    require_close(reflect(mirror, reflect(mirror, circle)).dual, circle.dual, 2e-12);
    const Sphere sphere = sphere_from(random.point(), 0.5 + std::abs(random.number()));
    const Sphere between = reflect(mirror, sphere), back = reflect(mirror, between);
    const double loss = 1e-12 * (1 + std::abs(between.no) + length(between.e) + std::abs(between.ni));
    CHECK(std::abs(back.no - sphere.no) < loss);
    CHECK(length(back.e - sphere.e) < loss);
    CHECK(std::abs(back.ni - sphere.ni) < loss);
  }
}

TEST_CASE("The center of a sphere goes to infinity and infinity to the center, planes keep infinity") {
  const Sphere ball = sphere_from({1, 2, 3}, 0.5);
  CHECK(reflect(ball, Point{1, 2, 3}) == Point::at_infinity());
  require_close(reflect(ball, Point::at_infinity()), {1, 2, 3});
  const Sphere plane = plane_from({1, 2, 3}, {1, 1, 0});
  CHECK(reflect(plane, Point::at_infinity()) == Point::at_infinity());
  CHECK(is_mirror(ball));
  CHECK(is_mirror(plane));
  CHECK_FALSE(is_mirror(sphere_from({1, 2, 3}, 0)));
  CHECK_FALSE(is_mirror({}));
}

TEST_CASE("Reflected circles and spheres pass through reflected points, circles in their order") {
  RandomElements random(3);
  for (int i = 0; i < 200; ++i) {
    const Sphere mirror = i % 2 == 0 ? plane_from(random.point(), random.vector())
                                     : sphere_from(random.point(4), 0.5 + std::abs(random.number()));
    const Point a = random.point(), b = random.point(), c = random.point();
    const auto expected = coordinates(circle_through(reflect(mirror, a), reflect(mirror, b), reflect(mirror, c)));
    const auto found = coordinates(reflect(mirror, circle_through(a, b, c)));
    REQUIRE(expected);
    REQUIRE(found);
    require_close(found->center, expected->center, 1e-7);
    require_close(found->normal, expected->normal, 1e-7);
    CHECK(found->radius == Approx(expected->radius).epsilon(1e-6));
    const Point center = random.point();
    const Sphere image = reflect(mirror, sphere_from(center, 0.7));
    const auto ball = coordinates(image);
    REQUIRE(ball);
    REQUIRE_FALSE(ball->plane);
    for (int k = 0; k < 4; ++k) {
      const Point on = to_point(to_vector(center) + 0.7 * normalized(random.vector()));
      CHECK(distance(reflect(mirror, on), ball->center) == Approx(ball->radius).epsilon(1e-8));
    }
  }
}

TEST_CASE("A circle through the center of the mirror becomes a line, and comes back") {
  const Sphere mirror = sphere_from({1, 0, 0}, 1);
  const Circle line = reflect(mirror, circle_from({0, 0, 0}, {0, 0, 1}, 1));
  const auto found = coordinates(line);
  REQUIRE(found);
  REQUIRE(found->line);
  require_close(found->point, {0.5, 0, 0}, 1e-14);
  const auto back = coordinates(reflect(mirror, line));
  REQUIRE(back);
  REQUIRE_FALSE(back->line);
  CHECK(back->radius == Approx(1).epsilon(1e-13));
  require_close(back->normal, {0, 0, 1}, 1e-13);
}

TEST_CASE("A reflected generator moves the reflected point as the generator moves the point") {
  RandomElements random(4);
  for (int i = 0; i < 200; ++i) {
    const Sphere mirror = i % 2 == 0 ? plane_from(random.point(), random.vector())
                                     : sphere_from(to_point(3 * normalized(random.vector())), 1);
    const Generator b = random.generator(0.2);
    const Point p = random.point(0.5);
    const Point first = reflect(mirror, *apply(exponential(b), p));
    const Point second = *apply(exponential(reflect(mirror, b)), reflect(mirror, p));
    require_close(first, second, 1e-11);
  }
}

TEST_CASE("Directions are carried as differences of reflected points") {
  RandomElements random(5);
  for (int i = 0; i < 200; ++i) {
    const Sphere mirror = i % 2 == 0 ? plane_from(random.point(), random.vector())
                                     : sphere_from(to_point(3 * normalized(random.vector())), 1);
    const Vector p = random.vector(0.5), v = normalized(random.vector());
    const double h = 1e-5;
    const Vector ahead = to_vector(reflect(mirror, to_point(p + h * v)));
    const Vector behind = to_vector(reflect(mirror, to_point(p - h * v)));
    require_close(reflect_at(mirror, to_point(p), v), normalized(ahead - behind), 1e-7);
  }
}
