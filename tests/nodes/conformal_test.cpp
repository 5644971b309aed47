// Reflections, meets, distances, motions between elements, and the flow of a generator, in graphs.

#include "algebra/extract.h"
#include "geometry/measure.h"
#include "tests/nodes/one_node.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

std::string port_of_problem(CatalogueGraph graph) {
  const Problems problems = graph.problems("it");
  return problems.empty() ? "" : problems.front().code + " at " + problems.front().port;
}

const Json mirrors = {{"plane", make("plane", {{"point", {1, 0, 0}}, {"normal", {1, 0, 0}}})},
                      {"ball", make("sphere", {{"center", {3, 0, 0}}, {"radius", 1.5}})},
                      {"mesh", make("sphere_mesh", {{"center", {0.2, 0, 0}}, {"segments", 48}, {"rings", 24}})}};

/// Volume by the divergence theorem: below 0 for a mesh that is inside out.
double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector a = to_vector(mesh.positions[triangle[0]]), b = to_vector(mesh.positions[triangle[1]]),
                 c = to_vector(mesh.positions[triangle[2]]);
    sum += dot(a, cross(b, c)) / 6;
  }
  return sum;
}

}  // namespace

TEST_CASE("A reflected mesh keeps its outside, in a plane and in a sphere") {
  for (const char* mirror : {"plane", "ball"}) {
    CAPTURE(mirror);
    CatalogueGraph graph = graph_with("reflect", {{"shape", from("mesh")}, {"mirror", from(mirror)}}, mirrors);
    const SharedMesh mesh = graph.one<SharedMesh>("it");
    CHECK(signed_volume(*mesh) > 0.01);
    REQUIRE(mesh->normals.size() == mesh->positions.size());
    for (const auto& triangle : mesh->triangles) {
      const Vector a = to_vector(mesh->positions[triangle[0]]), b = to_vector(mesh->positions[triangle[1]]),
                   c = to_vector(mesh->positions[triangle[2]]);
      const Vector face = cross(b - a, c - a);
      REQUIRE(dot(face, mesh->normals[triangle[0]]) >= 0);
    }
    CHECK(graph.warnings().empty());
  }
}

TEST_CASE("A mesh around the center of the mirror comes out inside out") {
  Json others = mirrors;
  others["within"] = make("sphere", {{"center", {0.2, 0, 0}}, {"radius", 2}});
  const SharedMesh mesh =
      graph_with("reflect", {{"shape", from("mesh")}, {"mirror", from("within")}}, others).one<SharedMesh>("it");
  CHECK(signed_volume(*mesh) == Approx(-4.0 / 3 * 3.14159265 * 64).epsilon(0.02));
}

TEST_CASE("A mesh that touches the center of the mirror is cut there with a warning") {
  Json others = mirrors;
  others["at"] = make("sphere", {{"center", {1.2, 0, 0}}, {"radius", 1}});
  CatalogueGraph graph = graph_with("reflect", {{"shape", from("mesh")}, {"mirror", from("at")}}, others);
  const SharedMesh mesh = graph.one<SharedMesh>("it");
  REQUIRE(graph.warnings().size() == 1);
  CHECK(graph.warnings()[0].code == "at-infinity");
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) CHECK(is_finite(mesh->positions[i]));
}

TEST_CASE("Points go through infinity and come back by two reflections") {
  Json others = mirrors;
  others["points"] = make("list", {{"items", {{3, 0, 0}, {4, 1, 0}, {0, 0, 0}}}});
  others["there"] = make("reflect", {{"shape", from("points")}, {"mirror", from("ball")}});
  CatalogueGraph graph = graph_with("reflect", {{"shape", from("there")}, {"mirror", from("ball")}}, others);
  CHECK(graph.all<Point>("there")[0] == Point::at_infinity());
  const std::vector<Point> back = graph.all<Point>("it");
  require_close(back[0], {3, 0, 0}, 1e-15);
  require_close(back[1], {4, 1, 0}, 1e-14);
  require_close(back[2], {0, 0, 0}, 1e-14);
}

TEST_CASE("A meet tells over a family where two spheres cross, touch and are apart") {
  const Json others = {{"x", make("list", {{"items", {1, 2, 3}}})},
                       {"way", make("vector", {{"x", from("x")}})},
                       {"unit", make("sphere")},
                       {"moved", make("translate", {{"shape", from("unit")}, {"vector", from("way")}})}};
  CatalogueGraph graph = graph_with("meet", {{"shape", from("unit")}, {"sphere", from("moved")}}, others);
  CHECK(graph.all<double>("it.kind") == std::vector<double>{1, 0, -1});
  const std::vector<Circle> circles = graph.all<Circle>("it");
  CHECK(coordinates(circles[0])->radius == Approx(std::sqrt(0.75)));
  CHECK(coordinates(circles[1])->radius == 0);
  CHECK(coordinates(circles[2])->radius == 0);
  require_close(coordinates(circles[2])->center, {1.5, 0, 0}, 1e-15);
  CHECK(graph.all<Point>("it.a")[2] == Point::at_infinity());
  CHECK(port_of_problem(graph_with("meet", {{"shape", from("unit")}, {"sphere", from("unit")}}, others)) ==
        "degenerate at sphere");
}

TEST_CASE("Two points of a circle and a sphere, and the pair through them") {
  const Json others = {{"ring", make("circle", {{"radius", 2}})}, {"plane", make("plane", {{"normal", {1, 0, 0}}})}};
  CatalogueGraph graph = graph_with("meet", {{"shape", from("ring")}, {"sphere", from("plane")}}, others);
  CHECK(graph.one<double>("it.kind") == 1);
  require_close(graph.one<Point>("it.a"), {0, 2, 0}, 1e-15);
  require_close(graph.one<Point>("it.b"), {0, -2, 0}, 1e-15);
  Json poles = others;
  poles["met"] = make("meet", {{"shape", from("ring")}, {"sphere", from("plane")}});
  CatalogueGraph ends = graph_with("poles_of", {{"shape", from("met")}}, poles);
  require_close(ends.one<Point>("it.a"), {0, 2, 0}, 1e-14);
  require_close(ends.one<Point>("it.b"), {0, -2, 0}, 1e-14);
}

TEST_CASE("Distances take every two kinds of elements, points as literals too") {
  const Json others = {{"ring", make("circle", {{"radius", 2}})},
                       {"ball", make("sphere", {{"center", {0, 0, 4}}, {"radius", 1}})},
                       {"spot", make("point", {{"position", {0, 0, 1}}})}};
  const auto distance_of = [&](const Json& a, const Json& b) {
    return graph_with("distance", {{"shape", a}, {"other", b}}, others).one<double>("it");
  };
  CHECK(distance_of({0, 3, 4}, {0, 0, 0}) == 5);
  CHECK(distance_of({0, 3, 0}, from("ring")) == Approx(1));
  CHECK(distance_of(from("ring"), {0, 3, 0}) == Approx(1));
  CHECK(distance_of(from("spot"), from("ball")) == Approx(2));
  CHECK(distance_of(from("ball"), from("spot")) == Approx(2));
  CHECK(distance_of(from("ring"), from("ball")) == Approx(std::sqrt(20.0) - 1));
  CHECK(distance_of(from("ball"), from("ring")) == Approx(std::sqrt(20.0) - 1));
  CHECK(distance_of(from("ball"), from("ball")) == 0);
}

TEST_CASE("A circle blended to another by halves passes the middle, and the logarithm drives transform and orbit") {
  const Json others = {{"a", make("circle")},
                       {"b", make("circle", {{"center", {3, 0, 1}}, {"normal", {0, 1, 0}}, {"radius", 4}})},
                       {"spheres", make("sphere")},
                       {"wide", make("sphere", {{"radius", 4}})}};
  for (const char* method : {"similarity", "conformal"}) {
    CAPTURE(method);
    const auto half = coordinates(
        graph_with("blend", {{"from", from("a")}, {"to", from("b")}, {"method", method}}, others).one<Circle>("it"));
    REQUIRE(half);
    Json nodes = others;
    nodes["log"] = make("logarithm", {{"from", from("a")}, {"to", from("b")}, {"method", method}});
    const auto moved =
        coordinates(graph_with("transform", {{"shape", from("a")}, {"generator", from("log")}, {"amount", 0.5}}, nodes)
                        .one<Circle>("it"));
    require_close(moved->center, half->center, 1e-13);
    CHECK(moved->radius == Approx(half->radius).epsilon(1e-13));
    if (std::string(method) == "similarity") CHECK(half->radius == Approx(2).epsilon(1e-13));
    const Json whole = {{"shape", from("a")}, {"from", from("a")}, {"to", from("b")}, {"method", method}};
    const auto there = coordinates(graph_with("transform_between", whole, others).one<Circle>("it"));
    require_close(there->center, {3, 0, 1}, 1e-12);
    require_close(there->normal, {0, 1, 0}, 1e-12);
    CHECK(there->radius == Approx(4).epsilon(1e-12));
  }
  const auto ball =
      coordinates(graph_with("blend", {{"from", from("spheres")}, {"to", from("wide")}}, others).one<Sphere>("it"));
  CHECK(ball->radius == Approx(2).epsilon(1e-13));
}

TEST_CASE("The point at infinity has no velocity, and every other point has one that is finite") {
  const Json others = {{"tau", make("point_pair")},
                       {"far", make("reflect", {{"shape", from("o")}, {"mirror", from("ball")}})},
                       {"ball", make("sphere")},
                       {"o", make("point")}};
  CHECK(port_of_problem(graph_with("flow", {{"point", from("far")}, {"generator", from("tau")}}, others)) ==
        "degenerate at point");
  CHECK(is_finite(graph_with("flow", {{"point", {1e6, 2, 3}}, {"generator", from("tau")}}, others).one<Vector>("it")));
}
