// Screws: logarithm, square root, and the motor between two lines.

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "algebra/versor.h"
#include "geometry/angle.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

void require_same_action(const Versor& a, const Versor& b, double tolerance = 1e-12) {
  for (const Point& p : {Point{1, 2, 3}, Point{-2, 0.5, 1}, Point{0, 0, 0}})
    require_close(*apply(a, p), *apply(b, p), tolerance);
}

TEST_CASE("A screw motor turns about its axis and slides along it") {
  const Versor motor = screw_motor(line_from({1, 0, 5}, {0, 0, 1}), pi / 2, 3);
  require_close(*apply(motor, Point{2, 0, 0}), {1, 1, 3});
  REQUIRE(screw_motor(circle_from({0, 0, 0}, {0, 0, 1}, 1), 1, 1) == Versor{});
}

TEST_CASE("The exponential undoes the logarithm of a motor") {
  RandomElements random(31);
  for (int i = 0; i < 200; ++i) {
    const Versor motor = screw_motor(line_from(random.point(), random.vector()), random.number(4), random.number(3));
    const auto logarithm = motor_logarithm(motor);
    REQUIRE(logarithm);
    require_same_action(exponential(*logarithm), motor);
    const Versor root = exponential(0.5 * *logarithm);
    require_same_action(compose(root, root), motor);
  }
}

TEST_CASE("Logarithms of tiny turns, half turns and pure translations are exact") {
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-6, pi - 1e-9, pi}) {
    CAPTURE(angle);
    const Versor motor = screw_motor(line_from({1, 2, 0}, {0, 0, 1}), angle, 0.7);
    require_same_action(exponential(*motor_logarithm(motor)), motor);
  }
  REQUIRE_FALSE(motor_logarithm(exponential(null_pair({0, 0, 0}, {1, 0, 0}))));
  REQUIRE_FALSE(motor_logarithm(scaling_versor({0, 0, 0}, 2)));
  REQUIRE_FALSE(motor_logarithm(Versor{0, {}, {}}));
}

void require_carries(const Versor& motor, const Circle& from, const Circle& to, double tolerance = 1e-12) {
  const auto image = coordinates(apply(motor, from)), target = coordinates(to);
  REQUIRE(image);
  REQUIRE(image->line);
  require_close(image->direction, target->direction, tolerance);
  require_close(image->point, target->point, tolerance);
}

TEST_CASE("The motor between two lines carries one to the other") {
  RandomElements random(32);
  for (int i = 0; i < 200; ++i) {
    const Circle from = line_from(random.point(), random.vector()), to = line_from(random.point(), random.vector());
    const auto motor = motor_between(from, to);
    REQUIRE(motor);
    require_carries(*motor, from, to, 1e-10);
    const auto logarithm = motor_logarithm(*motor);
    const auto a = coordinates(from), b = coordinates(to);
    const double angle = std::atan2(length(cross(a->direction, b->direction)), dot(a->direction, b->direction));
    REQUIRE(2 * length(logarithm->e_e) == Approx(angle).epsilon(1e-9));
  }
}

TEST_CASE("Parallel lines are carried by a translation and opposite ones by a half turn") {
  const Circle up = line_from({0, 0, 0}, {0, 0, 1}), shifted = line_from({2, 0, 1}, {0, 0, 1});
  const auto parallel = motor_between(up, shifted);
  REQUIRE(parallel);
  require_same_action(*parallel, translation_versor({2, 0, 0}));
  for (const Circle& to : {line_from({2, 0, 0}, {0, 0, -1}), line_from({0, 0, 0}, {0, 0, -1})}) {
    const auto opposite = motor_between(up, to);
    REQUIRE(opposite);
    require_carries(*opposite, up, to);
    require_same_action(compose(*opposite, *opposite), Versor{});
  }
  REQUIRE_FALSE(motor_between(up, circle_from({0, 0, 0}, {0, 0, 1}, 1)));
  REQUIRE_FALSE(motor_between(Circle{}, up));
}

}  // namespace
