#include "geometry/field_line.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/never_stopped.h"

using namespace dini;
using namespace dini::support;

namespace {

Vector around(const Vector& p) { return normalized({-p.y, p.x, 0}); }

double spread(const FieldLine& line) {
  double least = 1e300, most = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const double gap = length(line.points[i] - line.points[i - 1]);
    least = std::min(least, gap);
    most = std::max(most, gap);
  }
  return most - least;
}

}  // namespace

TEST_CASE("A line that comes back closes, whatever its length and its number of points are") {
  for (const double radius : {0.01, 1.0, 30.0}) {
    for (const double way : {100.0 * radius, -7.0 * radius, 1e5 * radius}) {
      for (const std::size_t count : {5u, 64u, 1000u}) {
        CAPTURE(radius, way, count);
        const FieldLine line = field_line(around, {radius, 0, 0}, {way, count, 1e6}, never_stopped);
        REQUIRE(line.closed);
        REQUIRE(line.points.size() == count);
        CHECK(line.length == Approx(8 * std::atan(1.0) * radius).epsilon(1e-5));
        CHECK(line.points.front() == line.points.back());
        CHECK(spread(line) < 1e-4 * radius);
        for (const Vector& point : line.points) CHECK(length(point) == Approx(radius).epsilon(1e-5));
        CHECK((line.points[1].y > 0) == (way > 0));
      }
    }
  }
}

TEST_CASE("A line shorter than its way around stays open") {
  const FieldLine line = field_line(around, {1, 0, 0}, {6, 13, 100}, never_stopped);
  CHECK_FALSE(line.closed);
  CHECK(line.length == 6);
  CHECK(length(line.points.back() - Vector{std::cos(6.0), std::sin(6.0), 0}) < 1e-6);
}

TEST_CASE("A line ends at the clip radius, and both ways when asked") {
  const auto ahead = [](const Vector&) { return Vector{1, 0, 0}; };
  const FieldLine line = field_line(ahead, {1, 2, 0}, {50, 11, std::sqrt(29.0)}, never_stopped);
  CHECK(line.points.front() == Vector{1, 2, 0});
  CHECK(length(line.points.back() - Vector{5, 2, 0}) < 1e-12);
  const FieldLine both = field_line(ahead, {1, 2, 0}, {50, 11, std::sqrt(29.0), true}, never_stopped);
  CHECK(length(both.points.front() - Vector{-5, 2, 0}) < 1e-12);
  CHECK(length(both.points.back() - Vector{5, 2, 0}) < 1e-12);
  CHECK(both.length == Approx(10));
  CHECK(spread(both) < 1e-12);
  for (const Vector& point : field_line(ahead, {9, 0, 0}, {50, 11, 5}, never_stopped).points)
    CHECK(point == Vector{9, 0, 0});
}

TEST_CASE("A line ends where the field ends, turns back, or is cancelled") {
  const auto inward = [](const Vector& p) { return p.x > 0.25 ? Vector{-1, 0, 0} : Vector{}; };
  CHECK(field_line(inward, {1, 0, 0}, {5, 20, 100}, never_stopped).length == Approx(0.75).epsilon(1e-4));
  const auto to_origin = [](const Vector& p) { return normalized(-p); };
  CHECK(field_line(to_origin, {1, 0, 0}, {5, 20, 100}, never_stopped).length == Approx(1).epsilon(1e-4));
  const auto nowhere = [](const Vector&) { return Vector{}; };
  for (const Vector& point : field_line(nowhere, {1, 0, 0}, {5, 20, 100}, never_stopped).points)
    CHECK(point == Vector{1, 0, 0});
  const Cancel stopped;
  stopped.stop(StopReason::superseded);
  CHECK(field_line(around, {1, 0, 0}, {5, 20, 100}, stopped).points.size() == 20);
  CHECK(field_line(around, {1, 0, 0}, {5, 1, 100}, never_stopped).points.size() == 1);
  CHECK(field_line(around, {1, 0, 0}, {0, 3, 100}, never_stopped).length == 0);
}

TEST_CASE("A spiral that does not come back near its start runs on") {
  const auto spiral = [](const Vector& p) { return normalized(Vector{-p.y, p.x, 0} + 0.1 * p); };
  const FieldLine line = field_line(spiral, {1, 0, 0}, {20, 400, 1e3}, never_stopped);
  CHECK_FALSE(line.closed);
  CHECK(line.length == 20);
  CHECK(length(line.points.back()) == Approx(1 + 20 * 0.1 / std::sqrt(1.01)).epsilon(1e-5));
}
