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

TEST_CASE("A contour stops where the field gives no direction, and needs a plane") {
  Json nodes = {{"dipole", make("point_pair")},
                {"it", make("contour", {{"point", {0, 0, 0}}, {"generators", {from("dipole")}}})}};
  for (const Point& point : graph_of(nodes).all<Point>("it")) CHECK(point == Point{0, 0, 0});
  nodes["it"]["inputs"]["normal"] = {0, 0, 0};
  REQUIRE(graph_of(nodes).problems("it").size() == 1);
}
