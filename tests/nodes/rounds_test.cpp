// Circles and spheres made and taken apart, and random samples.

#include "algebra/extract.h"
#include "tests/nodes/one_node.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json tilted = {{"ring", make("circle", {{"center", {1, 2, 3}}, {"normal", {0, 3, 4}}, {"radius", 2}})}};
const Json line_as_ring = {{"ring", make("line", {{"point", {1, 2, 3}}, {"direction", {0, 3, 4}}})}};

}  // namespace

TEST_CASE("The circle through three points passes through them in their order") {
  const auto circle = coordinates(
      graph_with("circle_through", {{"a", {2, 0, 0}}, {"b", {0, 2, 0}}, {"c", {-2, 0, 0}}}).one<Circle>("it"));
  REQUIRE(circle);
  require_close(circle->center, {0, 0, 0}, 1e-15);
  require_close(circle->normal, {0, 0, 1}, 1e-15);
  CHECK(circle->radius == Approx(2).epsilon(1e-15));
}

TEST_CASE("Collinear points give their line, coincident ones an error") {
  CHECK(coordinates(
            graph_with("circle_through", {{"a", {0, 0, 1}}, {"b", {1, 0, 1}}, {"c", {3, 0, 1}}}).one<Circle>("it"))
            ->line);
  CHECK(problem_of(graph_with("circle_through", {{"a", {0, 0, 1}}, {"b", {0, 0, 1}}, {"c", {3, 0, 1}}})) ==
        "degenerate");
}

TEST_CASE("The axis of a circle runs through its center along its normal") {
  CatalogueGraph graph = graph_with("axis_of", {{"shape", from("ring")}}, tilted);
  const auto axis = coordinates(graph.one<Circle>("it.axis"));
  REQUIRE(axis->line);
  require_close(axis->direction, {0, 0.6, 0.8}, 1e-15);
  require_close(graph.one<Vector>("it.direction"), {0, 0.6, 0.8}, 1e-15);
  // The point nearest the origin.
  require_close(axis->point, to_point(Vector{1, 2, 3} - 3.6 * Vector{0, 0.6, 0.8}), 1e-15);
  CHECK(problem_of(graph_with("axis_of", {{"shape", from("ring")}}, line_as_ring)) == "degenerate");
}

TEST_CASE("The poles of a circle lie a radius away along its axis, and their pair has them as its ends") {
  CatalogueGraph graph = graph_with("poles_of", {{"shape", from("ring")}}, tilted);
  require_close(graph.one<Point>("it.a"), {1, 3.2, 4.6}, 1e-15);
  require_close(graph.one<Point>("it.b"), {1, 0.8, 1.4}, 1e-15);
  CatalogueGraph pair =
      graph_with("poles_of", {{"shape", from("pair")}},
                 {{"pair", make("point_pair_through", {{"a", {1, 3.2, 4.6}}, {"b", {1, 0.8, 1.4}}})}});
  const Point a = pair.one<Point>("it.a"), b = pair.one<Point>("it.b");
  CHECK(std::min(distance(a, {1, 3.2, 4.6}), distance(b, {1, 3.2, 4.6})) < 1e-14);
  CHECK(std::min(distance(a, {1, 0.8, 1.4}), distance(b, {1, 0.8, 1.4})) < 1e-14);
}

TEST_CASE("Pairs without two poles in space are decided") {
  const auto pair = [](double split) {
    return Json{{"pair", make("point_pair", {{"position", {1, 2, 3}}, {"direction", {0, 1, 0}}, {"split", split}})}};
  };
  CatalogueGraph null = graph_with("poles_of", {{"shape", from("pair")}}, pair(0));
  require_close(null.one<Point>("it.a"), {1, 2, 3}, 1e-15);
  require_close(null.one<Point>("it.b"), {1, 2, 3}, 1e-15);
  require_close(graph_with("poles_of", {{"shape", from("pair")}}, pair(0.5)).one<Point>("it.a"), {1, 3, 3}, 1e-14);
  CHECK(problem_of(graph_with("poles_of", {{"shape", from("pair")}}, pair(-0.5))) == "degenerate");
  CHECK(problem_of(graph_with("poles_of", {{"shape", from("ring")}}, line_as_ring)) == "degenerate");
  CatalogueGraph flat =
      graph_with("poles_of", {{"shape", from("flat")}}, {{"flat", make("flat_point", {{"position", {1, 2, 3}}})}});
  require_close(flat.one<Point>("it.a"), {1, 2, 3}, 1e-15);
  CHECK(flat.one<Point>("it.b") == Point::at_infinity());
}

TEST_CASE("A line has its center at infinity and no radius") {
  CHECK(graph_with("center_of", {{"shape", from("ring")}}, line_as_ring).one<Point>("it") == Point::at_infinity());
  CHECK(problem_of(graph_with("radius_of", {{"shape", from("ring")}}, line_as_ring)) == "degenerate");
  require_close(graph_with("center_of", {{"shape", from("ring")}}, tilted).one<Point>("it"), {1, 2, 3}, 1e-15);
  CHECK(graph_with("radius_of", {{"shape", from("ring")}}, tilted).one<double>("it") == Approx(2).epsilon(1e-14));
}

TEST_CASE("A boosted sphere is the sphere through the boosted points") {
  const Json nodes = {{"ball", make("sphere", {{"center", {0.2, 0.1, 0}}, {"radius", 0.5}})},
                      {"tau", make("point_pair", {{"position", {1, 0, 1}}, {"direction", {0.3, 0.2, 0.4}}})},
                      {"spot", make("point", {{"position", {0.7, 0.1, 0}}})},
                      {"moved", make("boost", {{"shape", from("spot")}, {"generator", from("tau")}})}};
  const auto sphere =
      coordinates(graph_with("boost", {{"shape", from("ball")}, {"generator", from("tau")}}, nodes).one<Sphere>("it"));
  REQUIRE(sphere);
  CHECK(distance(graph_of(nodes).one<Point>("moved"), sphere->center) == Approx(sphere->radius).epsilon(1e-13));
}

TEST_CASE("The osculating sphere has the curvature asked for, and is the plane for none") {
  const auto sphere =
      coordinates(graph_with("osculating_sphere", {{"position", {1, 2, 3}}, {"normal", {0, 0, 2}}, {"curvature", 4}})
                      .one<Sphere>("it"));
  require_close(sphere->center, {1, 2, 2.75}, 1e-14);
  CHECK(sphere->radius == Approx(0.25).epsilon(1e-14));
  CHECK(coordinates(graph_with("osculating_sphere", {{"curvature", 0}}).one<Sphere>("it"))->plane);
  CHECK(problem_of(graph_with("osculating_sphere", {{"normal", {0, 0, 0}}})) == "degenerate");
}

TEST_CASE("Random samples depend on the seed and their place only, and stay in their range") {
  CatalogueGraph few = graph_with("random", {{"count", 10}, {"seed", 7}, {"from", 2}, {"to", 3}});
  CatalogueGraph many = graph_with(
      "random", {{"count", 2000}, {"seed", 7}, {"from", 2}, {"to", 3}, {"minimum", {0, 1, 5}}, {"maximum", {1, 2, 5}}});
  const std::vector<double> first = few.all<double>("it.values"), all = many.all<double>("it.values");
  CHECK(std::equal(first.begin(), first.end(), all.begin()));
  double sum = 0;
  for (const double value : all) {
    CHECK((value >= 2 && value < 3));
    sum += value;
  }
  CHECK(std::abs(sum / 2000 - 2.5) < 0.03);  // 4.6 standard deviations
  for (const Point& point : many.all<Point>("it.points")) CHECK((point.x < 1 && point.y >= 1 && point.z == 5));
  CHECK(graph_with("random", {{"count", 10}, {"seed", 8}, {"from", 2}, {"to", 3}}).all<double>("it.values") != first);
}
