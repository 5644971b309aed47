// Curves that are drawn by numbers and by points: the helix and the curve through points.

#include "tests/support/catalogue.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

constexpr double turn = 2 * 3.14159265358979323846;

double length_of(const std::vector<Point>& points, bool closed) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += distance(points[i], points[i + 1]);
  return closed ? sum + distance(points.back(), points.front()) : sum;
}

Json random_points(RandomElements& random, int count) {
  Json points = Json::array();
  for (int k = 0; k < count; ++k) {
    const Vector p = random.vector(3);
    points.push_back({p.x, p.y, p.z});
  }
  return points;
}

std::vector<Point> curve_of(const Json& items, Json inputs) {
  inputs["points"] = from("given");
  return graph_of({{"given", make("list", {{"items", items}})}, {"it", make("curve", inputs)}}).all<Point>("it");
}

Point point_of(const Json& item) { return {item[0], item[1], item[2]}; }

}  // namespace

TEST_CASE("A helix has its radius, its pitch and its length") {
  const Json nodes = {{"it", make("helix", {{"center", {1, 2, 3}},
                                            {"direction", {0, 0, 2}},
                                            {"radius", 2},
                                            {"pitch", 0.7},
                                            {"turns", 2.5},
                                            {"count", 4001}})}};
  const std::vector<Point> points = graph_of(nodes).all<Point>("it");
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(std::hypot(points[i].x - 1, points[i].y - 2) == Approx(2).epsilon(1e-14));
    CHECK(points[i].z - 3 == Approx(0.7 * 2.5 * static_cast<double>(i) / 4000).margin(1e-14));
  }
  CHECK(length_of(points, false) == Approx(2.5 * std::hypot(2 * turn, 0.7)).epsilon(1e-6));
  // Right hand: it turns from x to y as it climbs.
  const Vector first = to_vector(points[0]) - Vector{1, 2, 3}, next = to_vector(points[10]) - Vector{1, 2, 3};
  CHECK(cross(first, next).z > 0);
}

TEST_CASE("A helix with another radius at the end is a cone, with pitch 0 a flat spiral") {
  const Json nodes = {{"it", make("helix", {{"radius", 2}, {"end_radius", 0.5}, {"pitch", 0}, {"count", 31}})}};
  const std::vector<Point> points = graph_of(nodes).all<Point>("it");
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(points[i].z == 0);
    CHECK(std::hypot(points[i].x, points[i].y) == Approx(2 - 1.5 * static_cast<double>(i) / 30));
  }
  const auto end = [](const Json& inputs) { return graph_of({{"it", make("helix", inputs)}}).all<Point>("it").back(); };
  // Left hand below 0; back from the start with turns below 0.
  require_close(end({{"turns", 0.25}, {"pitch", -1}}), end({{"turns", 0.25}, {"pitch", 1}}), 0.51);
  CHECK(end({{"turns", 0.25}, {"pitch", -1}}).z == Approx(-0.25));
  CHECK(end({{"turns", -0.25}, {"pitch", 1}}).z == Approx(-0.25));
  CHECK(end({{"count", 1}}) == Point{end({{"turns", 0}}).x, end({{"turns", 0}}).y, 0});
}

TEST_CASE("A curve goes through its points, both kinds, open and closed") {
  RandomElements random(11);
  for (const char* kind : {"centripetal", "smooth"}) {
    for (const bool closed : {false, true}) {
      for (const int count : {2, 3, 4, 9}) {
        CAPTURE(kind, closed, count);
        const Json items = random_points(random, count);
        const int gaps = closed ? count : count - 1;
        const std::vector<Point> points = curve_of(
            items,
            {{"kind", kind}, {"closed", closed}, {"spacing", "points"}, {"count", closed ? 8 * gaps : 8 * gaps + 1}});
        for (int k = 0; k < count; ++k) {
          require_close(points[static_cast<std::size_t>(8 * k)], point_of(items[static_cast<std::size_t>(k)]));
        }
      }
    }
  }
}

TEST_CASE("A curve by length has even steps, and its ends") {
  RandomElements random(12);
  // Chords are shorter than the curve where it bends within a step, so it goes around, without sharp turns.
  const auto around = [&] {
    Json items = Json::array();
    for (int k = 0; k < 7; ++k) {
      const double angle = turn * k / 7, radius = 1 + random.number(0.2);
      items.push_back({radius * std::cos(angle), radius * std::sin(angle), random.number(0.3)});
    }
    return items;
  };
  for (const char* kind : {"centripetal", "smooth"}) {
    for (const bool closed : {false, true}) {
      CAPTURE(kind, closed);
      const Json items = around();
      const std::vector<Point> points = curve_of(items, {{"kind", kind}, {"closed", closed}, {"count", 1000}});
      CHECK(points.front() == point_of(items.front()));
      if (!closed) require_close(points.back(), point_of(items.back()), 1e-12);
      const double mean = length_of(points, closed) / (closed ? 1000 : 999);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        CHECK(distance(points[i], points[i + 1]) == Approx(mean).epsilon(0.01));
      }
    }
  }
}

TEST_CASE("A curve through points of a line stays on it, and two points give an even line") {
  const std::vector<Point> straight =
      curve_of({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {5, 10, 15}}, {{"kind", "smooth"}, {"count", 40}});
  for (const Point& p : straight) {
    CHECK(p.y == Approx(2 * p.x).margin(1e-12));
    CHECK(p.z == Approx(3 * p.x).margin(1e-12));
  }
  const std::vector<Point> two = curve_of({{0, 0, 0}, {4, 0, 0}}, {{"count", 5}});
  for (std::size_t i = 0; i < 5; ++i) require_close(two[i], {static_cast<double>(i), 0, 0});
  const std::vector<Point> there_and_back = curve_of({{0, 0, 0}, {4, 0, 0}}, {{"count", 4}, {"closed", true}});
  require_close(there_and_back[2], {4, 0, 0}, 1e-9);
}

TEST_CASE("A smooth curve through points of a circle is that circle to the fourth order") {
  const auto worst = [](int count) {
    Json items = Json::array();
    for (int k = 0; k < count; ++k) {
      items.push_back({std::cos(turn * k / count), std::sin(turn * k / count), 0});
    }
    double off = 0;
    for (const Point& p : curve_of(items, {{"kind", "smooth"}, {"closed", true}, {"count", 500}})) {
      off = std::max(off, std::abs(length(to_vector(p)) - 1));
    }
    return off;
  };
  CHECK(worst(16) < 1e-4);
  CHECK(worst(32) < worst(16) / 14);
}

TEST_CASE("Only the smooth kind has a continuous curvature, and a centripetal curve changes only nearby") {
  RandomElements random(13);
  const Json items = random_points(random, 8);
  Json moved = items;
  moved[0] = {9, 9, 9};
  const auto changes = [&](const char* kind) {
    const Json how = {{"kind", kind}, {"spacing", "points"}, {"count", 71}};
    const std::vector<Point> before = curve_of(items, how), after = curve_of(moved, how);
    return distance(before[45], after[45]);
  };
  CHECK(changes("centripetal") == 0);
  CHECK(changes("smooth") > 0);
  // Second differences by the parameter on both sides of a given point, where steps of the parameter are known.
  const auto jump = [&](const char* kind) {
    constexpr int gap = 1000;
    const std::vector<Point> p = curve_of(items, {{"kind", kind}, {"spacing", "points"}, {"count", 7 * gap + 1}});
    const auto step = [&](int k) {
      return std::sqrt(distance(point_of(items[static_cast<std::size_t>(k)]),
                                point_of(items[static_cast<std::size_t>(k + 1)]))) /
             gap;
    };
    const auto second = [&](std::size_t at, double h) {
      return (to_vector(p[at - 1]) - 2 * to_vector(p[at]) + to_vector(p[at + 1])) / (h * h);
    };
    return length(second(3 * gap - 1, step(2)) - second(3 * gap + 1, step(3)));
  };
  CHECK(jump("smooth") < 0.02 * jump("centripetal"));
}
