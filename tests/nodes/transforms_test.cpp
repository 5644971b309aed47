// The same transform of points, circles, generators and meshes must tell the same story.

#include <catch2/catch.hpp>
#include <cmath>

#include "algebra/extract.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Every transform with parameters that move everything, under its node type, and the nodes it needs.
struct Case {
  std::string type;
  Json inputs;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"boost", {{"generator", from("pair")}, {"amount", 0.4}}},
      {"transform", {{"generator", from("sum")}, {"amount", 0.3}}},
      {"twist", {{"axis", from("axis")}, {"angle", 50}, {"slide", 0.7}}},
      {"twist_between", {{"from", from("axis")}, {"to", from("other")}, {"amount", 0.6}}},
      {"translate", {{"vector", {0.5, -1, 2}}}},
      {"rotate", {{"axis", from("axis")}, {"angle", -70}}},
      {"scale", {{"center", {1, 0, 2}}, {"factor", 1.75}}}};
  return all;
}

Json transform_scene() {
  return {
      {"pair", make("point_pair", {{"position", {2, 1, -1}}, {"direction", {0.3, 0.2, 0.5}}})},
      {"lone", make("point_pair", {{"position", {-2, 0, 3}}, {"direction", {0.1, 0.4, 0}}, {"split", 0.2}})},
      {"sum", make("add", {{"generators", {from("pair"), from("lone")}}})},
      {"axis", make("line", {{"point", {1, 0, 0}}, {"direction", {0.2, 0.1, 1}}})},
      {"other", make("line", {{"point", {0, 2, 1}}, {"direction", {1, 0.5, 0}}})},
      {"ring", make("circle", {{"center", {0.5, 0.2, 0.1}}, {"normal", {0.3, 1, 0.4}}, {"radius", 0.8}})},
      {"ball", make("sphere_mesh", {{"center", {0.2, 0.4, 0.3}}, {"radius", 0.6}, {"segments", 24}, {"rings", 12}})}};
}

/// The scene and a case applied to the node `shape`, as the node "moved".
Json moving(const Case& one, const std::string& shape, Json nodes = transform_scene()) {
  nodes["moved"] = make(one.type, one.inputs);
  nodes["moved"]["inputs"]["shape"] = from(shape);
  return nodes;
}

/// The image of a point.
Point image(const Case& one, const Point& p) {
  Json nodes = transform_scene();
  nodes["p"] = make("point", {{"position", {p.x, p.y, p.z}}});
  return graph_of(moving(one, "p", nodes)).one<Point>("moved");
}

double distance_to(const CircleCoordinates& circle, const Point& p) {
  const Vector from_center = to_vector(p) - to_vector(circle.center);
  const double height = dot(from_center, circle.normal);
  return std::hypot(height, length(from_center - height * circle.normal) - circle.radius);
}

}  // namespace

TEST_CASE("A transformed circle holds the transformed points, in the same order") {
  for (const Case& one : cases()) {
    CAPTURE(one.type);
    Json nodes = transform_scene();
    nodes["points"] = make("sample", {{"shape", from("ring")}, {"count", 24}});
    const std::vector<Point> points = graph_of(moving(one, "points", nodes)).all<Point>("moved");
    const auto circle = coordinates(graph_of(moving(one, "ring")).one<Circle>("moved"));
    REQUIRE(circle);
    for (const Point& p : points) CHECK(distance_to(*circle, p) < 1e-12);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector a = to_vector(points[i]) - to_vector(circle->center);
      const Vector b = to_vector(points[(i + 1) % points.size()]) - to_vector(circle->center);
      CHECK(dot(cross(a, b), circle->normal) > 0);
    }
  }
}

TEST_CASE("A transformed mesh has the transformed points as vertices") {
  for (const Case& one : cases()) {
    CAPTURE(one.type);
    CatalogueGraph graph = graph_of(moving(one, "ball"));
    const auto before = graph.one<SharedMesh>("ball"), after = graph.one<SharedMesh>("moved");
    CHECK(graph.warnings().empty());
    REQUIRE(after->positions.size() == before->positions.size());
    CHECK(after->triangles == before->triangles);
    for (std::size_t i = 0; i < before->positions.size(); i += 17) {
      require_close(after->positions[i], image(one, before->positions[i]));
    }
  }
}

TEST_CASE("Normals follow a transformed mesh: a sphere stays a sphere with normals from its center") {
  for (const Case& one : cases()) {
    CAPTURE(one.type);
    const auto mesh = graph_of(moving(one, "ball")).one<SharedMesh>("moved");
    REQUIRE(mesh->normals.size() == mesh->positions.size());
    // The center from two normals' lines is the same for all vertices: p - r n for one radius r.
    const Vector between = to_vector(mesh->positions[30]) - to_vector(mesh->positions[200]);
    const Vector turned = mesh->normals[30] - mesh->normals[200];
    const double radius = dot(between, turned) / dot(turned, turned);
    CHECK(radius > 0);
    const Vector center = to_vector(mesh->positions[30]) - radius * mesh->normals[30];
    for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
      require_close(to_vector(mesh->positions[i]) - radius * mesh->normals[i], center, 1e-11);
    }
  }
}

TEST_CASE("A transformed generator does to transformed points what it did before") {
  for (const Case& one : cases()) {
    CAPTURE(one.type);
    Json nodes = moving(one, "lone");
    const Point start = {0.3, -0.4, 0.9}, moved_start = image(one, start);
    nodes["p"] = make("point", {{"position", {start.x, start.y, start.z}}});
    nodes["q"] = make("point", {{"position", {moved_start.x, moved_start.y, moved_start.z}}});
    nodes["acted"] = make("boost", {{"shape", from("p")}, {"generator", from("lone")}});
    nodes["acted_there"] = make("boost", {{"shape", from("q")}, {"generator", from("moved")}});
    CatalogueGraph graph = graph_of(nodes);
    require_close(graph.one<Point>("acted_there"), image(one, graph.one<Point>("acted")), 1e-11);
  }
}

TEST_CASE("Transforms do what their names say") {
  const Point p = {2, 1, 3};
  CHECK(image({"translate", {{"vector", {1, 2, 3}}}}, p) == Point{3, 3, 6});
  require_close(image({"scale", {{"center", {1, 1, 1}}, {"factor", 3}}}, p), Point{4, 1, 7});
  Json straight = transform_scene();
  straight["axis"] = make("line", {{"point", {1, 1, 0}}, {"direction", {0, 0, 4}}});
  straight["p"] = make("point", {{"position", {2, 1, 3}}});
  const auto about = [&](const Case& one) { return graph_of(moving(one, "p", straight)).one<Point>("moved"); };
  require_close(about({"rotate", {{"axis", from("axis")}, {"angle", 90}}}), Point{1, 2, 3});
  require_close(about({"twist", {{"axis", from("axis")}, {"angle", -90}, {"slide", -2}}}), Point{1, 0, 1});
  require_close(about({"twist", {{"axis", from("axis")}, {"angle", 720}, {"slide", 1}}}), Point{2, 1, 4});
}

TEST_CASE("Powers of a twist between lines compose, and the whole power takes one line to the other") {
  Json nodes = transform_scene();
  const auto power = [](const std::string& shape, double amount) {
    return make("twist_between",
                {{"shape", from(shape)}, {"from", from("axis")}, {"to", from("other")}, {"amount", amount}});
  };
  nodes["p"] = make("point", {{"position", {0.3, 0.4, 2}}});
  nodes["third"] = power("p", 0.3);
  nodes["rest"] = power("third", 0.7);
  nodes["whole"] = power("p", 1);
  nodes["nothing"] = power("p", 0);
  nodes["back"] = power("whole", -1);
  nodes["line"] = power("axis", 1);
  CatalogueGraph graph = graph_of(nodes);
  require_close(graph.one<Point>("rest"), graph.one<Point>("whole"));
  require_close(graph.one<Point>("nothing"), graph.one<Point>("p"));
  require_close(graph.one<Point>("back"), graph.one<Point>("p"));
  const auto moved = coordinates(graph.one<Circle>("line")), wanted = coordinates(graph.one<Circle>("other"));
  REQUIRE((moved && wanted && moved->line));
  require_close(moved->point, wanted->point);
  require_close(moved->direction, wanted->direction);
}

TEST_CASE("Axes that are no lines are degenerate") {
  for (const auto& [type, port] : {std::pair{"twist", "axis"}, {"rotate", "axis"}}) {
    Json nodes = transform_scene();
    nodes["n"] = make(type, {{"shape", from("pair")}, {port, from("ring")}});
    CHECK(codes(graph_of(nodes).problems("n")) == std::multiset<std::string>{"degenerate n.axis"});
  }
  Json nodes = transform_scene();
  nodes["n"] = make("twist_between", {{"shape", from("pair")}, {"from", from("ring")}, {"to", from("axis")}});
  CHECK(graph_of(nodes).problems("n").front().code == "degenerate");
}
