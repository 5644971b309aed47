#include "geometry/scalar_field.h"

#include <catch2/catch.hpp>

#include "algebra/extract.h"
#include "geometry/field_warp.h"
#include "tests/geometry/fields.h"

using namespace dini;
using namespace dini::support;

namespace {

Vector place_in(RandomElements& random, const SolidBall& ball) {
  Vector place;
  do place = random.vector();
  while (squared_length(place) > 1);
  return ball.center + ball.radius * place;
}

/// The distance from a sphere, below zero inside.
double distance_from(const Vector& place, const SphereCoordinates& sphere) {
  return length(place - to_vector(sphere.center)) - sphere.radius;
}

}  // namespace

TEST_CASE("A rounded minimum is the minimum where nothing else is near, and joins a right angle by a round fillet") {
  RandomElements random(1);
  for (int round = 0; round < 2000; ++round) {
    std::vector<double> numbers;
    for (int k = 0; k < 6; ++k) numbers.push_back(random.number());
    const double blend = 0.5 + random.number(0.5), least = *std::min_element(numbers.begin(), numbers.end());
    std::vector<double> shares(6), sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    const double rounded = rounded_minimum(numbers, blend, &shares);
    CHECK(rounded == rounded_minimum(sorted, blend));
    CHECK(rounded <= least);
    CHECK(rounded > least - blend);
    if (sorted[1] >= sorted[0] + blend) CHECK(rounded == least);
    double all = 0, excess = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(shares[k] >= 0);
      all += shares[k];
      excess += std::pow(std::max(0.0, rounded + blend - numbers[k]), 2);
    }
    CHECK(all == Approx(1).margin(1e-12));
    CHECK(excess == Approx(blend * blend).margin(1e-12));
  }
  // The circle of radius 1 that touches both lines at 1.
  const double turn = 0.3;
  CHECK(rounded_minimum(std::vector{1 - std::cos(turn), 1 - std::sin(turn)}, 1) == Approx(0).margin(1e-15));
}

TEST_CASE("The gradient of every field is that of its values") {
  RandomElements random(2);
  int smooth = 0;
  for (int round = 0; round < 200; ++round) {
    const SharedField field = random_field(random, 2);
    for (int k = 0; k < 10; ++k) {
      const Vector place = random.vector(2);
      const Slope slope = field->slope(place);
      CHECK(slope.value == Approx(value_at(*field, place)).margin(1e-12));
      const auto difference = [&](double step) {
        const auto along = [&](const Vector& e) {
          return (value_at(*field, place + step * e) - value_at(*field, place - step * e)) / (2 * step);
        };
        return Vector{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
      };
      const Vector coarse = difference(1e-4), fine = difference(1e-5);
      if (length(coarse - fine) > 1e-6 * (1 + length(fine))) continue;  // there is an edge of the field nearby
      ++smooth;
      CHECK(length(slope.gradient - fine) < 1e-5 * (1 + length(fine)));
    }
  }
  CHECK(smooth > 1500);
}

TEST_CASE("A field stays between its bounds in every ball, and is the same to the last bit where it was narrowed") {
  RandomElements random(3);
  int narrowed_fields = 0;
  for (int round = 0; round < 300; ++round) {
    const SharedField field = random_field(random, 3);
    const SolidBall ball{random.vector(2), 0.01 + 0.5 * std::pow(random.number(), 2)};
    const Narrowed narrowed = field->narrowed(ball, field);
    CHECK(narrowed.values.low <= narrowed.values.high);
    if (narrowed.field != field) ++narrowed_fields;
    for (int k = 0; k < 40; ++k) {
      const Vector place = place_in(random, ball);
      const double value = value_at(*field, place), slack = 1e-9 * (1 + std::abs(value));
      CHECK(value >= narrowed.values.low - slack);
      CHECK(value <= narrowed.values.high + slack);
      CHECK(value == value_at(*narrowed.field, place));
    }
  }
  CHECK(narrowed_fields > 100);
}

TEST_CASE("Bounds become as narrow as the ball") {
  RandomElements random(4);
  for (int round = 0; round < 100; ++round) {
    const SharedField field = random_field(random, 3);
    const Vector place = random.vector(1.5);
    const Interval values = field->narrowed({place, 1e-6}, field).values;
    CHECK(values.high - values.low < 1e-3);
  }
}

TEST_CASE(
    "The field of a boosted sphere is never more than the distance from its image, and is that distance outside") {
  RandomElements random(5);
  for (int round = 0; round < 300; ++round) {
    const Vector center = random.vector();
    const double radius = 0.3 + std::abs(random.number(0.5));
    const Versor boost = random_boost(random);
    const Sphere carried = apply(boost, sphere_from(to_point(center), radius));
    const SphereCoordinates image = coordinates(carried).value();
    if (image.plane || image.radius > 20) continue;
    const double side = carried.no < 0 ? -1 : 1;  // the boost may have turned it inside out
    const SharedField field = moved(sphere_field(center, radius), boost);
    for (int k = 0; k < 20; ++k) {
      const Vector place = random.vector(3);
      const double exact = side * distance_from(place, image), value = value_at(*field, place);
      CHECK(std::abs(value) <= std::abs(exact) + 1e-9);
      if (std::abs(exact) > 1e-9) CHECK((value > 0) == (exact > 0));
      if (exact > 0) CHECK(value == Approx(exact).margin(1e-9));
    }
    // Near the surface it is the distance on both sides.
    const Vector out = normalized(random.vector());
    const Vector below = to_vector(image.center) + (1 - side * 1e-4) * image.radius * out;
    CHECK(value_at(*field, below) / (side * distance_from(below, image)) == Approx(1).margin(2e-2));
  }
}

TEST_CASE("A boosted ring is at least as far as its field says, and as far where it is near") {
  RandomElements random(6);
  for (int round = 0; round < 20; ++round) {
    const Vector center = random.vector(), normal = normalized(random.vector());
    const Versor boost = exponential(null_pair(random.point(2), random.vector(0.2)));
    const SharedField ring = ring_field(center, normal, 0.6, 0.15), field = moved(ring, boost);
    for (int k = 0; k < 20; ++k) {
      // A place of the surface, found along a ray from the core of the tube.
      const Vector across = normalized(cross(normal, random.vector()));
      const Vector out = normalized(random.vector());
      double low = 0, high = 3;
      for (int step = 0; step < 60; ++step) {
        const double middle = (low + high) / 2;
        (value_at(*ring, center + 0.6 * across + middle * out) < 0 ? low : high) = middle;
      }
      const Point image = apply(boost, to_point(center + 0.6 * across + low * out)).value();
      CHECK(std::abs(value_at(*field, to_vector(image))) < 1e-9);
      const Vector normal_there = normalized(field->slope(to_vector(image)).gradient);
      CHECK(length(field->slope(to_vector(image)).gradient) == Approx(1).margin(1e-6));
      CHECK(value_at(*field, to_vector(image) + 1e-4 * normal_there) == Approx(1e-4).epsilon(1e-2));
      for (int other = 0; other < 20; ++other) {
        const Vector place = random.vector(3);
        CHECK(std::abs(value_at(*field, place)) <= length(place - to_vector(image)) + 1e-9);
      }
    }
  }
}

TEST_CASE("No field is NaN, not at the point that goes to infinity either") {
  const Versor boost = exponential(null_pair({0, 0, 0}, {0, 0, 0.5}));
  const Vector pole{0, 0, 2};  // what comes there was at infinity
  for (const SharedField& shape :
       {sphere_field({0.1, 0, 0}, 1), plane_field({0, 0, 1}, 0.2), sphere_field({0, 0, -2}, 1),
        ring_field({}, {0, 0, 1}, 0.5, 0.1), rod_field({}, {0, 1, 0}, 0.1)}) {
    const SharedField field = moved(shape, boost);
    for (const Vector& place :
         {pole, -pole, Vector{}, Vector{0, 0, 2 + 1e-15}, Vector{1e9, 0, 0}, Vector{0, 0, -1e9}}) {
      CHECK(std::isfinite(value_at(*field, place)));
      CHECK(is_finite(field->slope(place).gradient));
      const Interval values = field->narrowed({place, 0.5}, field).values;
      CHECK(values.low <= value_at(*field, place));
      CHECK(values.high >= value_at(*field, place));
    }
  }
}

TEST_CASE("What is no versor moves no field") {
  const SharedField field = sphere_field({}, 1);
  CHECK_FALSE(moved_field(field, Versor{0, {}, {}}));
  CHECK_FALSE(moved_field(field, versor_from(1, {{1, 0, 0}, {0, 0, 2}, 0.5, {0.3, 0, 1}})));
}

TEST_CASE(
    "A warped field is below zero where the opposite rotor at the place leads into the solid, and keeps its bounds") {
  RandomElements random(8);
  int bounded = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<kernels::WarpSource> sources;
    for (int k = 0; k < 3; ++k) {
      const Point position = random.point(1.5);
      const double kind = random.number();
      const Generator generator = kind < 0     ? null_pair(position, random.vector(0.4))
                                  : kind < 0.5 ? split_pair(position, random.vector(0.4), random.number(0.2))
                                               : 0.2 * flat_point(position);
      sources.push_back({generator, position});
    }
    const double strength = random.number(), power = round % 3 == 0 ? 2 : 3.5, softening = round % 2 == 0 ? 0.3 : 0;
    const SharedField shape = random_field(random, 1);
    const SharedField field = warped_field(shape, sources, strength, power, softening);
    for (int k = 0; k < 10; ++k) {
      const SolidBall ball{random.vector(1.5), 0.002 + 0.05 * std::pow(random.number(), 2)};
      const Narrowed narrowed = field->narrowed(ball, field);
      if (std::isfinite(narrowed.values.low)) ++bounded;
      for (int place_number = 0; place_number < 10; ++place_number) {
        const Vector place = place_in(random, ball);
        Generator sum;
        for (const auto& [generator, position] : sources) {
          const double distance = length(place - to_vector(position));
          sum = sum + (1 / (std::pow(distance, power) + softening)) * generator;
        }
        const Versor back = exponential(-strength * sum);
        const Vector source = to_vector(apply(back, to_point(place)).value());
        const double factor = length(apply_at(back, to_point(place), {1, 0, 0}));
        const double value = value_at(*field, place);
        if (length(source) < 1e3) {
          CHECK(value * factor == Approx(value_at(*shape, source)).margin(1e-7).epsilon(1e-7));
        }
        const double slack = 1e-9 * (1 + std::abs(value));
        CHECK(value >= narrowed.values.low - slack);
        CHECK(value <= narrowed.values.high + slack);
        CHECK(value == value_at(*narrowed.field, place));
      }
    }
  }
  CHECK(bounded > 500);
}
