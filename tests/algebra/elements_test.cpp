// Construction and extraction.

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/dense.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

TEST_CASE("A null pair is the translated tangent at the origin") {
  RandomElements random(21);
  for (int i = 0; i < 50; ++i) {
    const Point c = random.point(3);
    const Vector t = random.vector();
    require_close(null_pair(c, t), apply(translation_versor(to_vector(c)), Generator{t, {}, 0, {}}), 1e-13);
  }
}

TEST_CASE("Products of weighted points agree with the dense product") {
  RandomElements random(22);
  for (int i = 0; i < 50; ++i) {
    const Point a = random.point(), b = random.point();
    const double v = random.number(), w = random.number();
    const auto weighted = [](const Point& p, double weight) {
      return dense::from<double>(Sphere{weight, to_vector(p), 0.5 * squared_length(to_vector(p))});
    };
    const PointProduct product = point_product(a, v, b, w);
    const auto expected = weighted(a, v) * weighted(b, w);
    const auto value = dense::scalar(product.scalar) + dense::from<double>(product.generator);
    REQUIRE(dense::largest(value + -1.0 * expected) < 1e-14);
  }
}

TEST_CASE("Circles give back their coordinates") {
  RandomElements random(23);
  for (int i = 0; i < 100; ++i) {
    const Point c = random.point(5);
    const Vector n = normalized(random.vector());
    const double r = std::abs(random.number(3)) + 0.01;
    const auto found = coordinates(circle_from(c, 7 * n, r));
    REQUIRE(found);
    REQUIRE_FALSE(found->line);
    require_close(found->center, c, 1e-13);
    require_close(found->normal, n, 1e-14);
    REQUIRE(found->radius == Approx(r).epsilon(1e-10));
    const auto scaled = coordinates(Circle{-2.5 * circle_from(c, n, r).dual});
    require_close(scaled->normal, -n, 1e-14);
  }
}

TEST_CASE("Lines give back their direction and nearest point") {
  RandomElements random(24);
  for (int i = 0; i < 100; ++i) {
    const Vector u = normalized(random.vector()), p = random.vector(5);
    const auto found = coordinates(line_from(to_point(p), 3 * u));
    REQUIRE(found);
    REQUIRE(found->line);
    require_close(found->direction, u, 1e-14);
    require_close(to_vector(found->point), p - dot(p, u) * u, 1e-13);
  }
}

TEST_CASE("Spheres and planes give back their coordinates") {
  const auto sphere = coordinates(sphere_from({1, 2, 3}, 0.5));
  REQUIRE(sphere);
  require_close(sphere->center, {1, 2, 3});
  REQUIRE(sphere->radius == Approx(0.5));
  const auto plane = coordinates(plane_from({0, 0, 4}, {0, 0, -2}));
  REQUIRE(plane);
  REQUIRE(plane->plane);
  require_close(plane->normal, {0, 0, -1});
  REQUIRE(plane->distance == Approx(-4));
  REQUIRE_FALSE(coordinates(Sphere{1, {0, 0, 0}, 1}));
}

TEST_CASE("A circle through three points contains them in order") {
  RandomElements random(25);
  for (int i = 0; i < 100; ++i) {
    const Point a = random.point(), b = random.point(), c = random.point();
    const auto circle = coordinates(circle_through(a, b, c));
    REQUIRE(circle);
    for (const Point& p : {a, b, c}) REQUIRE(distance(p, circle->center) == Approx(circle->radius).epsilon(1e-9));
    REQUIRE(dot(circle->normal, cross(to_vector(b) - to_vector(a), to_vector(c) - to_vector(a))) > 0);
  }
}

TEST_CASE("Collinear points give the line in their cyclic order") {
  const auto line = coordinates(circle_through({1, 1, 0}, {2, 2, 0}, {4, 4, 0}));
  REQUIRE(line);
  REQUIRE(line->line);
  require_close(line->direction, normalized({1, 1, 0}));
  REQUIRE(coordinates(circle_through({0, 0, 1}, {1, 0, 1}, Point::at_infinity()))->direction == Vector{1, 0, 0});
  REQUIRE(coordinates(circle_through({0, 0, 1}, Point::at_infinity(), {1, 0, 1}))->direction == Vector{-1, 0, 0});
}

TEST_CASE("Degenerate elements are the zero element and have no coordinates") {
  REQUIRE(circle_through({1, 2, 3}, {1, 2, 3}, {4, 5, 6}) == Circle{});
  REQUIRE(circle_through({1, 2, 3}, {4, 5, 6}, {4, 5, 6}) == Circle{});
  REQUIRE(line_from({1, 2, 3}, {}) == Circle{});
  REQUIRE_FALSE(coordinates(circle_from({1, 2, 3}, {}, 1)));
  REQUIRE_FALSE(coordinates(Circle{}));
  REQUIRE_FALSE(coordinates(Sphere{}));
  REQUIRE_FALSE(coordinates(Circle{split_pair({0, 0, 0}, {0, 0, 1}, 0.5)}));
  REQUIRE(rotation_generator(Circle{}) == Generator{});
}

TEST_CASE("Points run counter-clockwise about the normal of a circle and along a line") {
  const auto circle = *coordinates(circle_from({1, 0, 0}, {0, 0, 1}, 2));
  const Vector start = to_vector(point_at(circle, 0)) - Vector{1, 0, 0};
  const Vector quarter = to_vector(point_at(circle, 0.25)) - Vector{1, 0, 0};
  require_close(cross(start, quarter), {0, 0, 4});
  require_close(point_at(circle, 1), point_at(circle, 0));
  const auto line = *coordinates(line_from({0, 3, 0}, {1, 0, 0}));
  require_close(point_at(line, 0.5, 10), {5, 3, 0});
}

TEST_CASE("The rotation generator of a line turns by the right hand") {
  const Generator turn = rotation_generator(line_from({1, 0, 0}, {0, 0, 2}));
  const double quarter = 1.5707963267948966;
  require_close(*apply(exponential(-0.5 * quarter * turn), Point{2, 0, 0}), {1, 1, 0});
}

TEST_CASE("A flat point scales and a direction translates") {
  require_close(*apply(exponential(0.5 * std::log(3.0) * flat_point({1, 0, 0})), Point{2, 1, 0}), {4, 3, 0});
  require_close(*apply(exponential(0.25 * direction_generator({1, 2, 3})), Point{0, 0, 0}), {-0.5, -1, -1.5});
  require_close(*apply(scaling_versor({1, 0, 0}, -2), Point{2, 1, 0}), {-1, -2, 0});
  for (const double factor : {1e-9, 1.7e-5, 1.0 / 3, 1.0, 2.5, 12345.678, 1e9 / 3, -0.001, -7654.321}) {
    CAPTURE(factor);
    const Point scaled = *apply(scaling_versor({0, 0, 0}, factor), Point{1, 0.5, -3});
    for (const auto& [found, wanted] :
         {std::pair{scaled.x, factor}, {scaled.y, 0.5 * factor}, {scaled.z, -3 * factor}}) {
      CHECK(std::abs(found - wanted) <= 4e-16 * std::abs(factor) * 3);
    }
  }
  require_close(*apply(scaling_versor({1, 2, 3}, 0), Point{7, 8, 9}), {1, 2, 3});
}

}  // namespace
