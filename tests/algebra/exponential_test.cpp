// The exponential against squared Taylor series in long double, over every kind of generator.

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/dense.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

/// Largest coefficient of the difference over the largest of the reference.
double error_of(const Generator& g) {
  const auto reference = dense::exponential(dense::from<long double>(g));
  const auto value = dense::from<long double>(exponential(g));
  return static_cast<double>(dense::largest(value + -1.0L * reference) / dense::largest(reference));
}

Generator rotations(double first, double second) {
  // two commuting turns: about the z axis, and along the unit circle of the plane z = 0
  return first * rotation_generator(line_from({0, 0, 0}, {0, 0, 1})) +
         second * rotation_generator(circle_from({0, 0, 0}, {0, 0, 1}, 1));
}

TEST_CASE("Exponentials of random generators are exact") {
  RandomElements random(11);
  for (const double scale : {1e-9, 1e-4, 0.01, 0.3, 1.0, 3.0}) {
    for (int i = 0; i < 100; ++i) REQUIRE(error_of(random.generator(scale)) < 1e-14 * (1 + 30 * scale));
  }
}

TEST_CASE("Exponentials of sums of null pairs are exact") {
  RandomElements random(12);
  for (int i = 0; i < 200; ++i) REQUIRE(error_of(random.pair() + random.pair()) < 3e-14);
}

TEST_CASE("Null generators are exactly null, even far from the origin") {
  const Generator g = null_pair({1000, -2000, 3000}, {0.3, 0.5, -0.1});
  const Versor v = exponential(g);
  REQUIRE(v.scalar == 1);
  REQUIRE(v.bivector == g);
  REQUIRE(v.quad == Sphere{});
}

TEST_CASE("Exponentials are exact where the split into commuting parts degenerates") {
  for (const double angle : {1e-9, 1e-4, 0.1, 1.0, 3.0, 10.0}) {
    for (const double gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.3, 0.5, 0.9, 1.0}) {
      for (const double sign : {1.0, -1.0}) {
        CAPTURE(angle, gap, sign);
        REQUIRE(error_of(rotations(angle, sign * angle * (1 - gap))) < 1e-14 * (1 + angle));
      }
    }
  }
}

TEST_CASE("Screws, translations, scalings and direct sums are exact") {
  RandomElements random(13);
  for (int i = 0; i < 50; ++i) {
    const Vector u = random.vector();
    const Generator turn = rotation_generator(line_from(random.point(), u));
    REQUIRE(error_of(2.0 * turn + direction_generator(0.7 * u)) < 1e-14);
    REQUIRE(error_of(direction_generator(u)) < 1e-15);
    REQUIRE(error_of(flat_point(random.point())) < 1e-14);
    REQUIRE(error_of(flat_point({0, 0, 0}) + rotation_generator(line_from({0, 0, 0}, u))) < 1e-14);
    REQUIRE(error_of(split_pair(random.point(), u, random.number())) < 1e-14);
  }
}

TEST_CASE("The opposite generator undoes the exponential") {
  RandomElements random(14);
  for (int i = 0; i < 100; ++i) {
    const Generator g = i % 3 == 0   ? random.pair()
                        : i % 3 == 1 ? split_pair(random.point(), random.vector(), random.number())
                                     : random.generator();
    const Versor product = compose(exponential(g), exponential(-1.0 * g));
    REQUIRE(dense::largest(dense::from<double>(product) + dense::scalar(-1.0)) < 1e-11);
  }
}

TEST_CASE("The paper's rule is the exact exponential for simple generators and up to scale only") {
  RandomElements random(15);
  for (int i = 0; i < 100; ++i) {
    const Generator simple = split_pair(random.point(), random.vector(), random.number());
    const Point p = random.point();
    require_close(*apply(exponential(simple, Rule::paper), p), *apply(exponential(simple), p), 1e-11);
  }
}

TEST_CASE("Huge and tiny generators neither overflow nor vanish") {
  RandomElements random(16);
  for (const Rule rule : {Rule::exact, Rule::paper}) {
    for (const double scale : {1e-300, 1e-200, 1e-160, 1e20, 1e77, 1e150, 1e155, 1e300, 1.7e308}) {
      const Versor v = exponential(scale * random.generator(0.5), rule);
      CAPTURE(scale);
      REQUIRE(std::isfinite(v.scalar));
      REQUIRE(std::isfinite(largest(v.bivector)));
      if (scale < 1e100) REQUIRE(apply(v, Point{1, 2, 3}).has_value());
    }
  }
  // saturation: any large amount of a real pair sends everything to the same end
  const Generator real = split_pair({0, 0, 0}, {1, 0, 0}, 0.5);
  require_close(*apply(exponential(1e6 * real), Point{3, 4, 5}), *apply(exponential(1e100 * real), Point{3, 4, 5}));
}

}  // namespace
