// The fast products and actions against the dense reference, and the laws they must keep.

#include "algebra/versor.h"

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/frame.h"
#include "tests/support/close.h"
#include "tests/support/dense.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

using Dense = dense::Multivector<double>;

double difference(const Dense& a, const Dense& b) { return dense::largest(a + -1.0 * b); }

TEST_CASE("Composition and reversal agree with the dense product") {
  RandomElements random(1);
  for (int i = 0; i < 200; ++i) {
    const Versor a = random.versor(), b = random.versor();
    REQUIRE(difference(dense::from<double>(compose(a, b)), dense::from<double>(a) * dense::from<double>(b)) < 1e-14);
    REQUIRE(difference(dense::from<double>(reverse(a)), dense::reverse(dense::from<double>(a))) == 0);
  }
}

TEST_CASE("Any even element moves points to the center of the dense sandwich") {
  RandomElements random(2);
  for (int i = 0; i < 200; ++i) {
    const Versor v = random.versor();
    const Point p = random.point(2);
    const auto expected = dense::apply(dense::from<double>(v), p.x, p.y, p.z);
    require_close(*apply(v, p), Point{expected[0], expected[1], expected[2]}, 1e-10);
  }
}

TEST_CASE("Rotors act on generators, circles and spheres as the dense sandwich") {
  RandomElements random(3);
  for (int i = 0; i < 200; ++i) {
    const Versor v = exponential(random.generator());
    const Dense dense_v = dense::from<double>(v), reversed = dense::reverse(dense_v);
    const Generator g = random.generator();
    const Sphere s{random.number(), random.vector(), random.number()};
    REQUIRE(is_versor(v));
    const double scale = dense::largest(dense_v) * dense::largest(dense_v);
    REQUIRE(difference(dense::from<double>(apply(v, g)), dense_v * dense::from<double>(g) * reversed) < 1e-13 * scale);
    REQUIRE(difference(dense::from<double>(apply(v, s)), dense_v * dense::from<double>(s) * reversed) < 1e-13 * scale);
    REQUIRE(apply(v, Circle{g}).dual == apply(v, g));
  }
}

TEST_CASE("An even element that is no versor is recognized") {
  RandomElements random(4);
  REQUIRE_FALSE(is_versor(versor_from(1, null_pair({0, 0, 0}, {0, 1, 0}) + null_pair({1, 0, 0}, {0, 0, 1}))));
  REQUIRE_FALSE(is_versor(Versor{0, {}, {}}));
  REQUIRE(is_versor(Versor{}));
  REQUIRE(is_versor(versor_from(1, random.pair())));
}

TEST_CASE("Versors preserve the inner products of points") {
  RandomElements random(5);
  for (int i = 0; i < 100; ++i) {
    const Versor v = exponential(random.generator(0.5));
    const Sphere a = sphere_from(random.point(), 0), b = sphere_from(random.point(), 0);
    const Sphere x = apply(v, a), y = apply(v, b);
    const double before = dot(a.e, b.e) - a.no * b.ni - a.ni * b.no;
    const double after = dot(x.e, y.e) - x.no * y.ni - x.ni * y.no;
    REQUIRE(after == Approx(before).margin(1e-11));
  }
}

TEST_CASE("Composition applies the right factor first") {
  RandomElements random(6);
  for (int i = 0; i < 50; ++i) {
    const Versor a = exponential(random.pair(0.3)), b = exponential(random.generator(0.3));
    const Point p = random.point();
    require_close(*apply(compose(a, b), p), *apply(a, *apply(b, p)), 1e-10);
  }
}

TEST_CASE("A boost sends its pole to infinity and infinity to its mirror pole") {
  const Point c{1, 2, -1};
  const Vector a{0.5, -0.25, 1};
  const Versor boost = exponential(null_pair(c, a));
  const Point pole = to_point(to_vector(c) - a / squared_length(a));
  const auto far = apply(boost, pole);
  REQUIRE((!is_finite(*far) || length(to_vector(*far)) > 1e12));
  require_close(*apply(boost, Point::at_infinity()), to_point(to_vector(c) + a / squared_length(a)));
  require_close(*apply(boost, c), c);
  REQUIRE(*apply(exponential(null_pair({0, 0, 0}, {1, 0, 0})), Point{-1, 0, 0}) == Point::at_infinity());
  REQUIRE(*apply(translation_versor({1, 2, 3}), Point::at_infinity()) == Point::at_infinity());
  REQUIRE_FALSE(apply(Versor{0, {}, {}}, Point{1, 2, 3}).has_value());
}

TEST_CASE("The differential of the action is its difference quotient") {
  RandomElements random(7);
  for (int i = 0; i < 100; ++i) {
    const Versor v = i % 2 == 0 ? exponential(random.generator(0.5)) : exponential(random.generator(0.5), Rule::paper);
    const Point p = random.point();
    const Vector step = random.vector();
    const double h = 1e-5;
    const auto ahead = apply(v, to_point(to_vector(p) + h * step)),
               behind = apply(v, to_point(to_vector(p) - h * step));
    const Vector quotient = (to_vector(*ahead) - to_vector(*behind)) / (2 * h);
    if (length(quotient) < 100) require_close(apply_at(v, p, step), quotient, 1e-6);
  }
}

TEST_CASE("Changing the origin of a generator is a translation") {
  RandomElements random(8);
  for (int i = 0; i < 50; ++i) {
    const Generator g = random.generator();
    const Vector origin = random.vector(3);
    require_close(seen_from(g, origin), apply(translation_versor(-origin), g), 1e-13);
  }
}

}  // namespace
