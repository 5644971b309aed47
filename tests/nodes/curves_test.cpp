// Orbits and the curves across them.

#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("An orbit holds what boosts of its amounts give") {
  const Json nodes = {
      {"tau", make("point_pair", {{"position", {0.1, 0.2, 0}}, {"direction", {0, 1, 0.3}}, {"split", 0.2}})},
      {"spot", make("point", {{"position", {1, 0.5, 0.2}}})},
      {"t", make("range", {{"from", -1}, {"to", 1}, {"count", 9}})},
      {"orbit",
       make("orbit", {{"point", from("spot")}, {"generator", from("tau")}, {"from", -1}, {"to", 1}, {"count", 9}})},
      {"boosted", make("boost", {{"shape", from("spot")}, {"generator", from("tau")}, {"amount", from("t")}})}};
  CatalogueGraph graph = graph_of(nodes);
  const std::vector<Point> orbit = graph.all<Point>("orbit"), boosted = graph.all<Point>("boosted");
  REQUIRE(orbit.size() == 9);
  for (std::size_t i = 0; i < 9; ++i) require_close(orbit[i], boosted[i], 1e-13);
  require_close(orbit[4], {1, 0.5, 0.2}, 1e-15);
}

TEST_CASE("The contours of a source are circles about it, with points at even distances") {
  const Json nodes = {
      {"source", make("flat_point", {{"position", {1, 2, 0}}})},
      {"it",
       make("contour", {{"point", {1.5, 2, 0}}, {"generators", {from("source")}}, {"length", 3}, {"count", 61}})}};
  const std::vector<Point> points = graph_of(nodes).all<Point>("it");
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(distance(points[i], {1, 2, 0}) == Approx(0.5).epsilon(1e-7));
    if (i > 0) CHECK(distance(points[i], points[i - 1]) == Approx(0.05).epsilon(1e-3));
  }
}

TEST_CASE("The contours of a null dipole are circles through it, across its direction field") {
  const Json nodes = {
      {"dipole", make("point_pair", {{"direction", {0, 1, 0}}})},
      {"it",
       make("contour", {{"point", {0, 1, 0}}, {"generators", {from("dipole")}}, {"length", 1}, {"strength", 1e-4}})}};
  // Orbits are circles tangent to the direction at the dipole; contours are the circles tangent to the other axis.
  for (const Point& point : graph_of(nodes).all<Point>("it"))
    CHECK(distance(point, {0, 0.5, 0}) == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("An orbit ends where it leaves the clip radius, even on both sides of t = 0") {
  const Json nodes = {
      {"grow", make("flat_point")},
      {"slide", make("direction", {{"direction", {1, 0, 0}}})},
      {"swell",
       make("orbit", {{"generator", from("grow")}, {"from", -1}, {"to", 3}, {"count", 9}, {"clip_radius", 10}})},
      {"away",
       make("orbit", {{"generator", from("slide")}, {"from", 20}, {"to", -20}, {"count", 5}, {"clip_radius", 3}})},
      {"outside", make("orbit", {{"point", {5, 0, 0}}, {"generator", from("grow")}, {"clip_radius", 3}})}};
  CatalogueGraph graph = graph_of(nodes);
  const std::vector<Point> swell = graph.all<Point>("swell");
  CHECK(swell.front().x == Approx(std::exp(-2.0)));
  CHECK(swell.back().x == Approx(10));
  for (std::size_t i = 2; i < swell.size(); ++i) {
    CHECK(swell[i].x / swell[i - 1].x == Approx(swell[1].x / swell[0].x));
  }
  const std::vector<Point> away = graph.all<Point>("away");
  CHECK(away.front().x == Approx(-3));
  CHECK(away.back().x == Approx(3));
  for (const Point& point : graph.all<Point>("outside")) CHECK(point == Point::at_infinity());
}

TEST_CASE("A contour closes for any length, and is cut at the clip radius") {
  Json nodes = {{"source", make("flat_point", {{"position", {1, 2, 0}}})},
                {"it", make("contour", {{"point", {1.5, 2, 0}}, {"generators", {from("source")}}, {"count", 33}})}};
  for (const double length : {4.0, 50.0, -1000.0}) {
    nodes["it"]["inputs"]["length"] = length;
    const std::vector<Point> points = graph_of(nodes).all<Point>("it");
    CHECK(points.front() == points.back());
    for (const Point& point : points) CHECK(distance(point, {1, 2, 0}) == Approx(0.5).epsilon(1e-6));
  }
  nodes["it"]["inputs"]["clip_radius"] = 2.6;
  nodes["it"]["inputs"]["both_ways"] = true;
  const std::vector<Point> cut = graph_of(nodes).all<Point>("it");
  CHECK(length(to_vector(cut.front())) == Approx(2.6));
  CHECK(length(to_vector(cut.back())) == Approx(2.6));
  for (const Point& point : cut) CHECK(distance(point, {1, 2, 0}) == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("A contour stops where the field gives no direction, and needs a plane") {
  Json nodes = {{"dipole", make("point_pair")},
                {"it", make("contour", {{"point", {0, 0, 0}}, {"generators", {from("dipole")}}})}};
  for (const Point& point : graph_of(nodes).all<Point>("it")) CHECK(point == Point{0, 0, 0});
  nodes["it"]["inputs"]["normal"] = {0, 0, 0};
  REQUIRE(graph_of(nodes).problems("it").size() == 1);
}
