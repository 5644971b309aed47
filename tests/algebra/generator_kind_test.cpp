// Kinds of generators, and the parts of those that make two motions at once.

#include "algebra/generator_kind.h"

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/versor.h"

using namespace dini;

namespace {

double size(const Generator& g) { return length(g.no_e) + length(g.e_e) + std::abs(g.no_ni) + length(g.e_ni); }

double distance(const Generator& a, const Generator& b) { return size(a + -1.0 * b); }

Generator turn_about(const Point& point, const Vector& direction) {
  return rotation_generator(line_from(point, direction));
}

}  // namespace

TEST_CASE("Every simple generator is known for what it is, near the origin and far from it") {
  for (const double away : {0.0, 1.0, 300.0}) {
    CAPTURE(away);
    const Point place{away, -0.5 * away, 0.25};
    const Vector tangent{0.3, -1.2, 0.7};
    CHECK(kind_of(null_pair(place, tangent)) == GeneratorKind::null_pair);
    CHECK(kind_of(split_pair(place, tangent, 0.5)) == GeneratorKind::real_pair);
    CHECK(kind_of(split_pair(place, tangent, -0.5)) == GeneratorKind::imaginary_pair);
    CHECK(kind_of(flat_point(place)) == GeneratorKind::flat_point);
    CHECK(kind_of(direction_generator(tangent)) == GeneratorKind::direction);
    CHECK(kind_of(turn_about(place, tangent)) == GeneratorKind::rotation);
    CHECK(kind_of(circle_from(place, tangent, 2).dual) == GeneratorKind::imaginary_pair);
    CHECK(kind_of(point_product(place, 1, {1, 2, 3}, 1).generator) == GeneratorKind::real_pair);
  }
  CHECK(kind_of({}) == GeneratorKind::zero);
}

TEST_CASE("A screw, a spiral and a sum of pairs are general, and their parts are what they were made of") {
  const Generator turn = turn_about({1, 2, 0}, {0, 0, 1});
  const Generator slide = direction_generator({0, 0, 0.4}), swell = 0.3 * flat_point({1, 2, 5});
  for (const Generator& other : {slide, swell}) {
    const Generator sum = turn + other;
    REQUIRE(kind_of(sum) == GeneratorKind::general);
    const auto [moving, turning] = commuting_parts(sum);
    CHECK(distance(moving, other) < 1e-12);
    CHECK(distance(turning, turn) < 1e-12);
    CHECK(kind_of(moving, 1e-9) == kind_of(other));
    CHECK(kind_of(turning, 1e-9) == GeneratorKind::rotation);
  }
}

TEST_CASE("The parts of any generator are simple, commute, and add up") {
  const Generator first = null_pair({1, 0, 0}, {0, 0, 1}), second = null_pair({-1, 0.5, 2}, {1, 1, 0});
  const Generator third = split_pair({0, 3, 1}, {1, 0, -1}, 0.8), turn = turn_about({0, 1, 1}, {1, 2, 3});
  for (const Generator& sum : {first + second, first + third, third + turn, first + second + turn}) {
    const auto [a, b] = commuting_parts(sum);
    CHECK(distance(a + b, sum) < 1e-9 * size(sum));
    CHECK(kind_of(a, 1e-8) != GeneratorKind::general);
    CHECK(kind_of(b, 1e-8) != GeneratorKind::general);
    const Versor ab = compose(versor_from(0, a), versor_from(0, b)), ba = compose(versor_from(0, b), versor_from(0, a));
    CHECK(distance(ab.bivector, ba.bivector) < 1e-9 * size(sum) * size(sum));
  }
}

TEST_CASE("A simple generator is its own part, and isoclinic ones get one of their many pairs") {
  const Generator pair = split_pair({1, 2, 3}, {1, 0, 0}, 0.5);
  CHECK(commuting_parts(pair)[0] == pair);
  CHECK(commuting_parts(pair)[1] == Generator{});
  // A turn about a line and as fast a turn about the unit circle around it: the motion of a Hopf fibration.
  const Generator axis = turn_about({0, 0, 0}, {0, 0, 1}),
                  circle = rotation_generator(circle_from({0, 0, 0}, {0, 0, 1}, 1));
  const Generator isoclinic = axis + circle;
  REQUIRE(kind_of(isoclinic) == GeneratorKind::general);
  const auto [a, b] = commuting_parts(isoclinic);
  CHECK(distance(a + b, isoclinic) < 2e-4 * size(isoclinic));
  CHECK(kind_of(a, 1e-6) != GeneratorKind::general);
  CHECK(kind_of(b, 1e-6) != GeneratorKind::general);
}
