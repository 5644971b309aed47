#include "algebra/between.h"

#include <catch2/catch.hpp>

#include "algebra/extract.h"
#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

Circle random_circle(RandomElements& random) {
  return circle_from(random.point(), random.vector(), 0.3 + std::abs(random.number()));
}

void require_same(const Circle& value, const Circle& expected, double tolerance) {
  const auto found = coordinates(value), wanted = coordinates(expected);
  REQUIRE(found);
  REQUIRE(wanted);
  REQUIRE(found->line == wanted->line);
  require_close(found->center, wanted->center, tolerance);
  require_close(found->normal, wanted->normal, tolerance);
  CHECK(std::abs(found->radius - wanted->radius) <= tolerance);
  require_close(found->point, wanted->point, tolerance);
  require_close(found->direction, wanted->direction, tolerance);
}

}  // namespace

TEST_CASE("The exponential of the logarithm of a rotor acts as the rotor") {
  RandomElements random(31);
  for (int i = 0; i < 300; ++i) {
    const Generator b = random.generator(i % 2 == 0 ? 0.4 : 1.5);
    const Versor rotor = exponential(b);
    const auto logarithm = rotor_logarithm(rotor);
    REQUIRE(logarithm);
    const Point p = random.point();
    const Point expected = *apply(rotor, p);
    require_close(*apply(exponential(*logarithm), p), expected, 1e-10 * (1 + length(to_vector(expected))));
    if (i % 2 == 0) require_close(*logarithm, b, 1e-11);
    // A multiple is the same rotor.
    Versor scaled = compose(rotor, {-3, {}, {}});
    require_close(*rotor_logarithm(scaled), *logarithm, 1e-11);
  }
}

TEST_CASE("Logarithms of simple rotors are the generators they were made from") {
  RandomElements random(32);
  for (int i = 0; i < 100; ++i) {
    for (const Generator& b : {random.pair(2), direction_generator(random.vector(20)), 3 * flat_point(random.point()),
                               1.5 * rotation_generator(line_from(random.point(), random.vector())),
                               split_pair(random.point(), random.vector(), 0.8),
                               split_pair(random.point(), normalized(random.vector()), -0.8), Generator{}}) {
      const auto logarithm = rotor_logarithm(exponential(b));
      REQUIRE(logarithm);
      require_close(*logarithm, b, 2e-12);
    }
  }
}

TEST_CASE("What is no rotor has no logarithm") {
  CHECK_FALSE(rotor_logarithm({0, {}, {}}));
  CHECK_FALSE(rotor_logarithm({1, {{1, 0, 0}, {1, 0, 0}, 0, {}}, {}}));
  // Both turns are half turns: about the unit circle and about its axis.
  const Generator both =
      rotation_generator(circle_from({}, {0, 0, 1}, 1)) + rotation_generator(line_from({}, {0, 0, 1}));
  CHECK_FALSE(rotor_logarithm(exponential(1.57079632679489661923 * both)));
}

TEST_CASE("A similarity carries one circle to the other, with its orientation") {
  RandomElements random(33);
  for (int i = 0; i < 300; ++i) {
    const Circle a = random_circle(random), b = random_circle(random);
    const auto generator = similarity_between(a, b);
    REQUIRE(generator);
    require_same(apply(exponential(*generator), a), b, 1e-12);
    // Half of it twice is the whole.
    const Versor half = exponential(0.5 * *generator);
    require_same(apply(half, apply(half, a)), b, 1e-12);
    // It is a similarity: no boost in it, and lengths grow alike.
    CHECK(generator->no_e == Vector{});
    const Versor whole = exponential(*generator);
    const Point p = random.point(), q = random.point();
    const double ratio = coordinates(b)->radius / coordinates(a)->radius;
    CHECK(distance(*apply(whole, p), *apply(whole, q)) == Approx(ratio * distance(p, q)).epsilon(1e-11));
  }
}

TEST_CASE("Similarities between circles of nearly one size and direction keep their digits") {
  const Circle a = circle_from({1, 2, 3}, {0, 0, 1}, 1);
  for (const double little : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const double tilt : {0.0, 1e-12, 1e-6, 1e-3}) {
      const Circle b = circle_from({1.5, 2, 4}, {tilt, 0, 1}, 1 + little);
      require_same(apply(exponential(*similarity_between(a, b)), a), b, 1e-12);
    }
  }
  const Circle turned = circle_from({1, 2, 3}, {0, 0, -1}, 1);
  require_same(apply(exponential(*similarity_between(a, turned)), a), turned, 1e-12);
  CHECK_FALSE(similarity_between(a, line_from({}, {1, 0, 0})));
  CHECK_FALSE(similarity_between(a, circle_from({}, {0, 0, 1}, 0)));
}

TEST_CASE("The rotor between two circles or lines carries one to the other, with its orientation") {
  RandomElements random(34);
  for (int i = 0; i < 300; ++i) {
    const Circle a = i % 3 == 0 ? line_from(random.point(), random.vector()) : random_circle(random);
    const Circle b = i % 5 == 0 ? line_from(random.point(), random.vector()) : random_circle(random);
    const auto generator = rotor_between(a, b);
    REQUIRE(generator);
    require_same(apply(exponential(*generator), a), b, 1e-10);
    const Versor half = exponential(0.5 * *generator);
    require_same(apply(half, apply(half, a)), b, 1e-10);
  }
}

TEST_CASE("The rotor between circles of unit size carries one to the other to the last digits") {
  RandomElements random(35);
  for (int i = 0; i < 200; ++i) {
    const Circle a = circle_from(random.point(0.5), random.vector(), 1);
    const Circle b = circle_from(random.point(0.5), random.vector(), 1.5);
    require_same(apply(exponential(*rotor_between(a, b)), a), b, 1e-12);
  }
}

TEST_CASE("A circle and itself run the other way are half a turn apart") {
  RandomElements random(36);
  for (int i = 0; i < 50; ++i) {
    const Circle a = random_circle(random);
    const auto found = coordinates(a);
    const Circle reversed = circle_from(found->center, -found->normal, found->radius);
    require_same(apply(exponential(*rotor_between(a, reversed)), a), reversed, 1e-11);
    require_close(*rotor_between(a, a), Generator{}, 1e-12);
  }
}

TEST_CASE("Between concentric circles of one plane the rotor is a scaling, between lines the motor") {
  const Circle small = circle_from({1, 2, 3}, {0, 0, 1}, 1), wide = circle_from({1, 2, 3}, {0, 0, 1}, 4);
  const Generator growth = *rotor_between(small, wide);
  require_close(growth, std::log(2.0) * flat_point({1, 2, 3}), 1e-12);
  const Circle a = line_from({0, 0, 0}, {1, 0, 0}), b = line_from({0, 0, 2}, {0, 1, 0});
  require_close(*rotor_between(a, b), *motor_logarithm(*motor_between(a, b)), 1e-12);
}
