// Loxodromes, products of points, ratios of spheres, and Hopf fibers.

#include "algebra/extract.h"
#include "tests/nodes/one_node.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

CircleCoordinates circle_of(CatalogueGraph graph) { return coordinates(graph.one<Circle>("it")).value(); }

const Json unit_ring = {{"ring", make("circle")}};

}  // namespace

TEST_CASE("A loxodrome without its boost is a translation by -2 gamma b, without its translation a boost") {
  const Json spot = {{"spot", make("point", {{"position", {0.3, 0.2, 0.1}}})}};
  require_close(
      graph_with("loxodrome", {{"shape", from("spot")}, {"lambda", 0}, {"gamma", 0.5}}, spot).one<Point>("it"),
      {0.3, -0.8, 0.1}, 1e-15);
  Json others = spot;
  others["tau"] = make("point_pair", {{"direction", {1, 0, 0}}});
  others["boosted"] = make("boost", {{"shape", from("spot")}, {"generator", from("tau")}, {"amount", 0.7}});
  require_close(
      graph_with("loxodrome", {{"shape", from("spot")}, {"lambda", 0.7}, {"gamma", 0}}, spot).one<Point>("it"),
      graph_of(others).one<Point>("boosted"), 1e-15);
}

TEST_CASE("The product of a circle's poles of weight 1 carries it over the sphere") {
  const CircleCoordinates circle =
      circle_of(graph_with("product", {{"shape", from("ring")}, {"amount", 0.5}}, unit_ring));
  CHECK(circle.center.z * circle.center.z + circle.radius * circle.radius == Approx(1).epsilon(1e-14));
  // K ~K = 0: everything collapses to one pole.
  const CircleCoordinates end = circle_of(graph_with("product", {{"shape", from("ring")}, {"amount", 1}}, unit_ring));
  CHECK(end.radius < 1e-7);
  require_close(end.center, {0, 0, 1}, 1e-12);
}

TEST_CASE("At weight -1 the equator stays, and without an amount the product is zero") {
  const Json flat = {{"shape", from("ring")}, {"weight_a", -1}, {"weight_b", -1}, {"amount", 0.3}};
  const CircleCoordinates circle = circle_of(graph_with("product", flat, unit_ring));
  CHECK(circle.radius == Approx(1).epsilon(1e-14));
  require_close(circle.center, {0, 0, 0}, 1e-14);
  Json nothing = flat;
  nothing["amount"] = 0;
  CHECK(problem_of(graph_with("product", nothing, unit_ring)) == "degenerate");
}

TEST_CASE("The ratio of two spheres takes one to the other, half of it half the way") {
  const Json spheres = {{"a", make("sphere", {{"center", {0, 0, 0}}, {"radius", 1}})},
                        {"b", make("sphere", {{"center", {0.5, 0.2, 0.1}}, {"radius", 1.3}})},
                        {"far", make("sphere", {{"center", {7, 0, 0}}, {"radius", 2}})},
                        {"point", make("sphere", {{"radius", 0}})}};
  for (const std::string other : {"b", "far"}) {
    CAPTURE(other);
    const Json inputs = {{"shape", from("a")}, {"from", from("a")}, {"to", from(other)}};
    const SphereCoordinates moved = coordinates(graph_with("boost_between", inputs, spheres).one<Sphere>("it")).value();
    const SphereCoordinates wanted = coordinates(graph_of(spheres).one<Sphere>(other)).value();
    require_close(moved.center, wanted.center, 1e-13);
    CHECK(moved.radius == Approx(wanted.radius).epsilon(1e-13));
    Json half = inputs, others = spheres;
    half["amount"] = 0.5;
    others["first"] = make("boost_between", half);
    half["shape"] = from("first");
    require_close(coordinates(graph_with("boost_between", half, others).one<Sphere>("it"))->center, wanted.center,
                  1e-12);
  }
  CHECK(problem_of(graph_with("boost_between", {{"shape", from("a")}, {"from", from("a")}, {"to", from("point")}},
                              spheres)) == "degenerate");
  const SphereCoordinates same =
      coordinates(graph_with("boost_between", {{"shape", from("b")}, {"from", from("a")}, {"to", from("a")}}, spheres)
                      .one<Sphere>("it"))
          .value();
  CHECK(same.radius == Approx(1.3).epsilon(1e-13));
}

TEST_CASE("The paper's fibers have the center distance k/(1-k^2) + k/2, radius 1/(1-k^2) and tilt k * 90 degrees") {
  for (const double k : {0.0, 0.25, 0.5, 0.9}) {
    CAPTURE(k);
    const CircleCoordinates fiber = circle_of(
        graph_with("hopf", {{"shape", from("ring")}, {"theta", 0.3}, {"latitude", k}, {"method", "paper"}}, unit_ring));
    CHECK(length(to_vector(fiber.center)) == Approx(k / (1 - k * k) + k / 2).epsilon(1e-13).margin(1e-14));
    CHECK(fiber.radius == Approx(1 / (1 - k * k)).epsilon(1e-13));
    CHECK(fiber.normal.z == Approx(std::cos(k * std::acos(0.0))).epsilon(1e-13));
  }
}

TEST_CASE(
    "True fibers have the center distance tan a and the radius 1/cos a, on the side and with the tilt of the paper's") {
  for (const double k : {0.0, 0.25, 0.5, 0.9}) {
    CAPTURE(k);
    const auto by = [&](const char* method) {
      return circle_of(graph_with(
          "hopf", {{"shape", from("ring")}, {"theta", 0.3}, {"latitude", k}, {"method", method}}, unit_ring));
    };
    const CircleCoordinates fiber = by("exact"), paper = by("paper");
    const double tilt = k * std::acos(0.0);
    CHECK(fiber.radius == Approx(1 / std::cos(tilt)).epsilon(1e-13));
    CHECK(length(to_vector(fiber.center)) == Approx(std::tan(tilt)).epsilon(1e-13).margin(1e-14));
    require_close(fiber.normal, paper.normal, 1e-13);
    if (k > 0) require_close(normalized(to_vector(fiber.center)), normalized(to_vector(paper.center)), 1e-13);
  }
}

TEST_CASE("Both bundles end at the axis of the base, wherever the base is") {
  const Json base = {{"ring", make("circle", {{"center", {1, 2, 3}}, {"normal", {0, 0, 1}}, {"radius", 2.5}})}};
  for (const std::string method : {"paper", "exact"}) {
    CAPTURE(method);
    const CircleCoordinates axis = circle_of(
        graph_with("hopf", {{"shape", from("ring")}, {"theta", 0.7}, {"latitude", 1}, {"method", method}}, base));
    REQUIRE(axis.line);
    require_close(axis.direction, {0, 0, 1}, 1e-12);
    require_close(axis.point, {1, 2, 0}, 1e-11);
  }
  CHECK(problem_of(graph_with("hopf", {{"shape", from("ring")}}, {{"ring", make("line")}})) == "degenerate");
  CHECK(problem_of(graph_with("hopf", {{"shape", from("ring")}}, {{"ring", make("circle", {{"radius", 0}})}})) ==
        "degenerate");
}
