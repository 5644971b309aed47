#include "draco/octahedron.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "algebra/kernels.h"
#include "draco/attribute_kernels.h"

using namespace dini;

namespace {

/// Puts the choice of instruction set back.
struct RestoreInstructionSet {
  ~RestoreInstructionSet() { kernels::force_instruction_set(""); }
};

/// Directions by coordinates: random ones, along axes and edges, and none.
std::vector<std::vector<float>> directions() {
  std::vector<std::vector<float>> result(3);
  const auto add = [&](float x, float y, float z) {
    result[0].push_back(x);
    result[1].push_back(y);
    result[2].push_back(z);
  };
  for (const float x : {-1.0f, 0.0f, 1.0f}) {
    for (const float y : {-1.0f, 0.0f, 1.0f}) {
      for (const float z : {-1.0f, -0.0f, 0.0f, 1.0f}) add(x, y, z);
    }
  }
  std::mt19937 random(4);
  std::normal_distribution<float> normal;
  for (int i = 0; i < 1000; ++i) add(normal(random), normal(random), normal(random));
  return result;
}

// What a decoder does with a point (bitstream 2.2, "OctaherdalCoordsToUnitVector"), not normalized.
std::array<double, 3> direction_of(const Octahedron& octahedron, SquarePoint point) {
  double y = static_cast<double>(point.s) / octahedron.center() - 1;
  double z = static_cast<double>(point.t) / octahedron.center() - 1;
  const double x = 1 - std::abs(y) - std::abs(z);
  const double beyond = std::max(-x, 0.0);
  y += y < 0 ? beyond : -beyond;
  z += z < 0 ? beyond : -beyond;
  return {x, y, z};
}

TEST_CASE("Points stand for their directions") {
  const int bits = GENERATE(2, 6, 10, 16);
  const Octahedron octahedron(bits);
  const auto all = directions();
  for (std::size_t i = 0; i < all[0].size(); ++i) {
    const double x = all[0][i], y = all[1][i], z = all[2][i];
    const double size = std::abs(x) + std::abs(y) + std::abs(z);
    if (size == 0) continue;
    const auto [a, b, c] = direction_of(octahedron, octahedron.point({all[0][i], all[1][i], all[2][i]}));
    const double step = 1.0 / octahedron.center();
    CHECK(std::abs(a - x / size) <= 1.01 * step);
    CHECK(std::abs(b - y / size) <= 1.01 * step);
    CHECK(std::abs(c - z / size) <= 1.01 * step);
  }
}

TEST_CASE("Every instruction set gives the points and steps of the plain formulas") {
  const RestoreInstructionSet restore;
  const int bits = GENERATE(2, 10, 16);
  const Octahedron octahedron(bits);
  const auto all = directions();
  const std::size_t count = all[0].size();
  for (const char* name : kernels::instruction_sets()) {
    CAPTURE(name, bits);
    REQUIRE(kernels::force_instruction_set(name));
    std::vector<std::int32_t> s(count + 1, 0), t(count + 1, 0);
    kernels::octahedron_points(octahedron, {all[0].data(), all[1].data(), all[2].data()}, count, &s[1], &t[1]);
    std::vector<std::uint32_t> steps(2 * count);
    kernels::octahedron_steps(octahedron, s.data(), t.data(), count, steps.data());
    SquarePoint last;
    for (std::size_t i = 0; i < count; ++i) {
      const SquarePoint point = octahedron.point({all[0][i], all[1][i], all[2][i]});
      REQUIRE(point == SquarePoint{s[i + 1], t[i + 1]});
      const SquarePoint step = octahedron.step(last, point);
      REQUIRE(step ==
              SquarePoint{static_cast<std::int32_t>(steps[2 * i]), static_cast<std::int32_t>(steps[2 * i + 1])});
      last = point;
    }
  }
}

}  // namespace
