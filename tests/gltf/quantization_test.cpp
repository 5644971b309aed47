#include "gltf/quantization.h"

#include <catch2/catch.hpp>

using namespace dini;

namespace {

FloatBox box_of(const std::array<float, 3>& minimum, const std::array<float, 3>& maximum) {
  FloatBox box;
  box.include(minimum);
  box.include(maximum);
  return box;
}

TEST_CASE("The grid takes the largest extent on every axis") {
  const QuantizationGrid grid(box_of({-1, 0, 5}, {1, 8, 6}), 14);
  CHECK(grid.range() == 8.0f);
  CHECK(grid.box().minimum == std::array<float, 3>{-1, 0, 5});
  CHECK(grid.decoded(0, -1) == -1.0f);
  CHECK(grid.decoded(1, 8) == 8.0f);
  CHECK(grid.position_error() == Approx(4.0 / 16383).epsilon(0.05));
}

TEST_CASE("An empty grid and a grid of one point are exact") {
  CHECK(QuantizationGrid(FloatBox(), 14).decoded(1, 0) == 0.0f);
  const QuantizationGrid point(box_of({3, 4, 5}, {3, 4, 5}), 14);
  CHECK(point.decoded(2, 5) == 5.0f);
  CHECK(point.position_error() < 1e-6);
}

TEST_CASE("A grid of almost no extent stays finite") {
  const float tiny = 1e-42f;
  const QuantizationGrid grid(box_of({0, 0, 0}, {tiny, tiny, tiny}), 20);
  CHECK(grid.range() > 0.0f);
  CHECK(std::abs(grid.decoded(1, tiny)) <= grid.position_error());
}

TEST_CASE("An empty box has no size and includes nothing") {
  FloatBox box;
  CHECK(box.empty());
  CHECK(box.largest() == 0.0f);
  box.include(FloatBox());
  CHECK(box.empty());
  box.include(box_of({1, 2, -7}, {1, 2, 3}));
  CHECK_FALSE(box.empty());
  CHECK(box.largest() == 7.0f);
}

}  // namespace
