#include "algebra/network.h"

#include <catch2/catch.hpp>
#include <vector>

#include "algebra/flow.h"
#include "algebra/frame.h"
#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::kernels;

namespace {

struct WeightedCloud {
  std::vector<double> x, y, z, weights;
  std::vector<double> steps_x, steps_y, steps_z;

  void add(const Point& p, double weight) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
    weights.push_back(weight);
    for (auto* steps : {&steps_x, &steps_y, &steps_z}) steps->push_back(0);
  }
  std::size_t size() const { return x.size(); }
  Point at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  ConstPoints points() const { return {x.data(), y.data(), z.data()}; }
  Points steps() { return {steps_x.data(), steps_y.data(), steps_z.data()}; }

  /// All of it one step on.
  WeightedCloud next(const NetworkSettings& settings, Neighbors neighbors = {}) {
    WeightedCloud after = *this;
    step_network(settings, {points(), weights.data(), size(), neighbors}, 0, size(), steps(),
                 {after.x.data(), after.y.data(), after.z.data()});
    after.steps_x = steps_x;
    after.steps_y = steps_y;
    after.steps_z = steps_z;
    return after;
  }
};

WeightedCloud random_weighted_cloud(std::size_t size, std::uint64_t seed) {
  RandomElements random(seed);
  WeightedCloud cloud;
  for (std::size_t i = 0; i < size; ++i) cloud.add(random.point(), 2 * random.number());
  return cloud;
}

/// The sum of the products of eq. (19), each made in coordinates about the middle of its points.
Generator sum_of_products(const WeightedCloud& cloud, std::size_t i, const NetworkSettings& settings) {
  Generator sum;
  for (std::size_t j = 0; j < cloud.size(); ++j) {
    if (j == i) continue;
    const Vector a = to_vector(cloud.at(i)), b = to_vector(cloud.at(j)), middle = 0.5 * (a + b);
    const double d = length(b - a), rest = settings.rest / d;
    const double factor = settings.strength * (1 - rest * rest) / (std::pow(d, settings.power) + settings.softening);
    const PointProduct product =
        point_product(to_point(a - middle), cloud.weights[i], to_point(b - middle), cloud.weights[j]);
    sum = sum + factor * seen_from(product.generator, -middle);
  }
  return sum;
}

NetworkSettings gentle() {
  NetworkSettings settings;
  settings.strength = 0.01;
  settings.softening = 0.2;
  return settings;
}

}  // namespace

TEST_CASE("Each point goes where the exponential of the sum of its products carries it") {
  for (const double power : {2.0, 3.0, 2.2}) {
    for (const double rest : {0.0, 0.5}) {
      NetworkSettings settings = gentle();
      settings.power = power;
      settings.rest = rest;
      WeightedCloud cloud = random_weighted_cloud(37, 51);
      const WeightedCloud after = cloud.next(settings);
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        const auto expected = apply(exponential(sum_of_products(cloud, i, settings)), cloud.at(i));
        require_close(after.at(i), *expected, 1e-12);
      }
    }
  }
}

TEST_CASE("A point below weight 1 is drawn to its neighbor, above it goes away, and at 1 it rests") {
  for (const double weight : {0.0, 0.5, 1.0, 1.5, -1.0}) {
    WeightedCloud pair;
    pair.add({-1, 0, 0}, weight);
    pair.add({1, 0, 0}, 1);
    NetworkSettings settings = gentle();
    settings.softening = 0;
    const WeightedCloud after = pair.next(settings);
    // 2 (1 - w) h^2 h with h = 1, weighted by 1 / 4
    CHECK(after.x[0] + 1 == Approx(0.5 * (1 - weight) * 0.01).epsilon(0.05).margin(1e-15));
    CHECK(after.at(1) == pair.at(1));
    CHECK(after.y[0] == 0);
  }
}

TEST_CASE("At the rest distance neighbors leave one another alone") {
  WeightedCloud pair;
  pair.add({0, 0, 0}, 0);
  pair.add({0, 0.5, 0}, 0);
  NetworkSettings settings = gentle();
  settings.rest = 0.5;
  CHECK(pair.next(settings).at(0) == pair.at(0));
  settings.rest = 0.6;
  CHECK(pair.next(settings).y[0] < 0);
  settings.rest = 0.4;
  CHECK(pair.next(settings).y[0] > 0);
}

TEST_CASE("Steps are no longer than the longest, and no point leaves the ball") {
  NetworkSettings settings = gentle();
  settings.strength = 50;
  settings.softening = 0;
  settings.longest_step = 0.25;
  settings.center = {0.5, 0, 0};
  settings.radius = 1.5;
  WeightedCloud cloud = random_weighted_cloud(60, 52);
  for (int k = 0; k < 40; ++k) {
    WeightedCloud after = cloud.next(settings);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      REQUIRE(is_finite(after.at(i)));
      if (k > 0) REQUIRE(distance(after.at(i), cloud.at(i)) <= 0.25 * (1 + 1e-12));
      REQUIRE(distance(after.at(i), settings.center) <= 1.5 * (1 + 1e-12));
    }
    cloud = after;
  }
}

TEST_CASE("Without damping a point goes on as it went") {
  NetworkSettings settings = gentle();
  settings.strength = 0;
  settings.damping = 0.25;
  WeightedCloud cloud;
  cloud.add({0, 0, 0}, 0);
  cloud.steps_x[0] = 0.5;
  cloud = cloud.next(settings);
  CHECK(cloud.x[0] == Approx(0.375));
  cloud = cloud.next(settings);
  CHECK(cloud.x[0] == Approx(0.375 + 0.28125));
}

TEST_CASE("Points at one place do nothing to one another") {
  WeightedCloud cloud;
  cloud.add({1, 2, 3}, 0);
  cloud.add({1, 2, 3}, 0.5);
  NetworkSettings settings = gentle();
  settings.softening = 0;
  settings.rest = 0.1;
  const WeightedCloud after = cloud.next(settings);
  CHECK(after.at(0) == cloud.at(0));
  CHECK(after.at(1) == cloud.at(1));
}

TEST_CASE("A table of all neighbors is as good as none, and a point that is its own neighbor has one less") {
  WeightedCloud cloud = random_weighted_cloud(23, 53), again = cloud, fewer = cloud;
  const std::size_t size = cloud.size();
  std::vector<std::uint32_t> table(size * size), own(size);
  for (std::size_t m = 0; m < size; ++m) {
    own[m] = static_cast<std::uint32_t>(m);
    for (std::size_t i = 0; i < size; ++i) table[m * size + i] = static_cast<std::uint32_t>(m);
  }
  const WeightedCloud all = cloud.next(gentle()), listed = again.next(gentle(), {table.data(), size});
  const WeightedCloud alone = fewer.next(gentle(), {own.data(), 1});
  for (std::size_t i = 0; i < size; ++i) {
    CHECK(all.at(i) == listed.at(i));
    CHECK(alone.at(i) == fewer.at(i));
  }
}

TEST_CASE("Every instruction set gives the same bits of a network") {
  NetworkSettings settings = gentle();
  settings.power = 2.3;
  settings.rest = 0.3;
  settings.damping = 0.5;
  std::vector<WeightedCloud> results;
  for (const char* name : instruction_sets()) {
    REQUIRE(force_instruction_set(name));
    WeightedCloud cloud = random_weighted_cloud(67, 54);
    for (int k = 0; k < 5; ++k) cloud = cloud.next(settings);
    results.push_back(cloud);
  }
  force_instruction_set("");
  REQUIRE(results.size() > 1);
  for (const WeightedCloud& cloud : results) {
    CHECK(cloud.x == results.front().x);
    CHECK(cloud.y == results.front().y);
    CHECK(cloud.z == results.front().z);
  }
}
