#include "graph/wire.h"

#include <catch2/catch.hpp>

using namespace dini;

TEST_CASE("The color of a wire type is the one that pages show, made linear") {
  CHECK(info(WireType::circle).color == "#F3AF20");
  const Color circle = linear_color(WireType::circle);
  // 243, 175 and 32 of 255 in sRGB.
  CHECK(circle[0] == Approx(0.896269).margin(1e-6));
  CHECK(circle[1] == Approx(0.428690).margin(1e-6));
  CHECK(circle[2] == Approx(0.014444).margin(1e-6));
  CHECK(circle[3] == 1);
  CHECK(linear_color(WireType::point)[1] == 1);
}
