#include "algebra/flow.h"

#include <catch2/catch.hpp>

#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/dense.h"
#include "tests/support/random_elements.h"

using namespace dini;

namespace {

Vector along(const Generator& b, const Point& p, double t) { return to_vector(*apply(exponential(t * b), p)); }

struct Derivatives {
  Vector first, second, third;
};

/// By central differences of the fourth order.
Derivatives differences(const Generator& b, const Point& p) {
  const double h = 4e-3;
  const auto at = [&](int k) { return along(b, p, k * h); };
  return {(at(-2) - 8 * at(-1) + 8 * at(1) - at(2)) / (12 * h),
          (-at(-2) + 16 * at(-1) - 30 * at(0) + 16 * at(1) - at(2)) / (12 * h * h),
          (at(-3) - 8 * at(-2) + 13 * at(-1) - 13 * at(1) + 8 * at(2) - at(3)) / (8 * h * h * h)};
}

}  // namespace

TEST_CASE("Velocity, acceleration, curvature and torsion are those of differences along the orbit") {
  RandomElements random(41);
  for (int i = 0; i < 300; ++i) {
    const Generator b = random.generator(0.4);
    const Point p = random.point();
    const Flow flow = flow_at(b, p);
    const Derivatives d = differences(b, p);
    require_close(flow.velocity, d.first, 1e-6);
    require_close(flow.acceleration, d.second, 1e-6);
    const Vector bend = cross(d.first, d.second);
    const double speed = length(d.first);
    if (speed < 0.3 || length(bend) < 0.1) continue;
    CHECK(flow.curvature == Approx(length(bend) / (speed * speed * speed)).epsilon(1e-5).margin(1e-6));
    CHECK(flow.torsion == Approx(dot(bend, d.third) / squared_length(bend)).epsilon(1e-4).margin(1e-4));
  }
}

TEST_CASE("The velocity is the commutator of generator and point relative to its weight") {
  RandomElements random(42);
  for (int i = 0; i < 100; ++i) {
    const Generator b = random.generator();
    const Point p = random.point();
    const auto x = dense::point(p.x, p.y, p.z), g = dense::from<double>(b);
    const auto commutator = g * x + (-1.0) * (x * g);
    const double weight = commutator.c[16] - commutator.c[8];
    const Vector expected = Vector{commutator.c[1], commutator.c[2], commutator.c[4]} - weight * to_vector(p);
    require_close(flow_at(b, p).velocity, expected, 1e-12);
  }
}

TEST_CASE("A screw has the curvature and torsion of a helix, right-handed above 0") {
  // A turn by one radian and a climb of c per unit of t, at distance r from the axis.
  const double r = 2, c = 0.5;
  const Generator screw = -0.5 * rotation_generator(line_from({}, {0, 0, 1})) + direction_generator({0, 0, -0.5 * c});
  const Flow flow = flow_at(screw, {r, 0, 0});
  require_close(flow.velocity, {0, r, c}, 1e-15);
  require_close(flow.acceleration, {-r, 0, 0}, 1e-15);
  CHECK(flow.curvature == Approx(r / (r * r + c * c)).epsilon(1e-14));
  CHECK(flow.torsion == Approx(c / (r * r + c * c)).epsilon(1e-14));
}

TEST_CASE("Orbits of one pair are circles, those of scalings and shifts are straight") {
  RandomElements random(43);
  for (int i = 0; i < 100; ++i) {
    const Vector position = random.vector(), tangent = random.vector();
    const Point p = random.point(2);
    // The circle through p, tangent at the pair's point: its radius is |y|^2 / (2 |y x t|) for a unit tangent t.
    const Vector y = to_vector(p) - position;
    const Flow flow = flow_at(null_pair(to_point(position), tangent), p);
    CHECK(flow.curvature == Approx(2 * length(cross(y, normalized(tangent))) / squared_length(y)).epsilon(1e-9));
    CHECK(std::abs(flow.torsion) < 1e-9);
    const Flow scaled = flow_at(flat_point(to_point(position)), p);
    require_close(scaled.velocity, 2.0 * y, 1e-14);
    CHECK(scaled.curvature < 1e-14);
    CHECK(flow_at(direction_generator(tangent), p).curvature == 0);
  }
}

TEST_CASE("A point at the place of its generator rests") {
  const Flow flow = flow_at(null_pair({1, 2, 3}, {0, 1, 0}), {1, 2, 3});
  CHECK(flow.velocity == Vector{});
  CHECK(flow.acceleration == Vector{});
  CHECK(flow.curvature == 0);
  CHECK(flow.torsion == 0);
  CHECK(flow_at({}, {1, 2, 3}).velocity == Vector{});
}
