#include <catch2/catch.hpp>

#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

Json warp_scene() {
  return {{"a", make("point_pair", {{"position", {1, 0.5, 0}}, {"direction", {0.2, 0.3, 0.5}}})},
          {"b", make("point_pair", {{"position", {-1, 0, 0.5}}, {"direction", {0, -0.4, 0.1}}})},
          {"c", make("point_pair", {{"position", {0, -1.5, 1}}, {"direction", {0.3, 0, 0}}, {"split", 0.2}})},
          {"points", make("list", {{"items", {{0.2, 0.1, 0.3}, {-0.4, 0.8, 1.5}, {2, -1, 0}}}, {"axis", "p"}})}};
}

const Json three = {from("a"), from("b"), from("c")};

/// The points under a warp with these inputs.
std::vector<Point> warped(Json inputs, Json nodes = warp_scene()) {
  inputs["shape"] = from("points");
  nodes["warped"] = make("warp", std::move(inputs));
  return graph_of(nodes).all<Point>("warped");
}

void require_same(const std::vector<Point>& values, const std::vector<Point>& expected, double tolerance = 1e-12) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) require_close(values[i], expected[i], tolerance);
}

}  // namespace

TEST_CASE("A point at a generator of a warp stays, whatever the rule, the method and the softening") {
  Json nodes = warp_scene();
  nodes["points"] = make("list", {{"items", {{1, 0.5, 0}, {-1, 0, 0.5}}}});
  for (const char* rule : {"exact", "paper"}) {
    for (const double softening : {0.0, 1e-6}) {
      CAPTURE(rule, softening);
      const std::vector<Point> alone =
          warped({{"generators", {from("a")}}, {"rule", rule}, {"softening", softening}}, nodes);
      require_close(alone[0], Point{1, 0.5, 0});
    }
    for (const char* method : {"sum_generators", "sum_displacements"}) {
      const std::vector<Point> together =
          warped({{"generators", {from("a"), from("b")}}, {"rule", rule}, {"method", method}}, nodes);
      CAPTURE(rule, method);
      if (std::string(method) == "sum_generators") {
        require_close(together[0], Point{1, 0.5, 0});
        require_close(together[1], Point{-1, 0, 0.5});
      }
      for (const Point& p : together) CHECK(is_finite(p));
    }
  }
}

TEST_CASE("A warp by one generator is a boost with the weight of its distance") {
  Json nodes = warp_scene();
  for (const double power : {0.0, 1.0, 2.0, 3.0}) {
    nodes["offset"] = make("expression", {{"formula", "hypot(hypot(0.8, 0.4), 0.3) ^ x"}, {"x", power}});
    nodes["amount"] = make("expression", {{"formula", "0.7 / (x + 0.5)"}, {"x", from("offset")}});
    nodes["p"] = make("point", {{"position", {0.2, 0.1, 0.3}}});
    nodes["boosted"] = make("boost", {{"shape", from("p")}, {"generator", from("a")}, {"amount", from("amount")}});
    const std::vector<Point> found =
        warped({{"generators", {from("a")}}, {"strength", 0.7}, {"power", power}, {"softening", 0.5}}, nodes);
    CAPTURE(power);
    require_close(found[0], graph_of(nodes).one<Point>("boosted"));
  }
}

TEST_CASE("Summed displacements are those of each generator alone, added up") {
  const std::vector<Point> still = graph_of(warp_scene()).all<Point>("points");
  const std::vector<Point> together =
      warped({{"generators", three}, {"softening", 0.3}, {"method", "sum_displacements"}});
  std::vector<Point> expected = still;
  for (const Json& one : three) {
    const std::vector<Point> alone = warped({{"generators", {one}}, {"softening", 0.3}});
    for (std::size_t i = 0; i < still.size(); ++i) {
      expected[i] = to_point(to_vector(expected[i]) + (to_vector(alone[i]) - to_vector(still[i])));
    }
  }
  require_same(together, expected);
}

TEST_CASE("Generators as links and as one family over any axis warp alike") {
  Json nodes = warp_scene();
  nodes["family"] = make("list", {{"items", three}, {"axis", "g"}});
  nodes["k"] = make("range", {{"from", 0.5}, {"to", 1}, {"count", 2}});
  nodes["stronger"] = make("boost", {{"shape", from("family")}, {"generator", from("a")}, {"amount", from("k")}});
  const std::vector<Point> links = warped({{"generators", three}, {"softening", 0.3}});
  CHECK(warped({{"generators", from("family")}, {"softening", 0.3}}, nodes) == links);
  CHECK(warped({{"generators", from("family")}, {"over", "g"}, {"softening", 0.3}}, nodes) == links);
  CHECK(warped({{"generators", from("stronger")}, {"over", "g"}, {"softening", 0.3}}, nodes).size() == 6);
}

TEST_CASE("A mesh is warped vertex by vertex, with normals made anew") {
  Json nodes = warp_scene();
  nodes["ball"] = make("sphere_mesh", {{"radius", 0.5}, {"segments", 16}, {"rings", 8}});
  nodes["moved"] = make("warp", {{"shape", from("ball")}, {"generators", three}, {"softening", 0.4}});
  CatalogueGraph graph = graph_of(nodes);
  const auto before = graph.one<SharedMesh>("ball"), after = graph.one<SharedMesh>("moved");
  CHECK(after->triangles == before->triangles);
  REQUIRE(after->normals.size() == after->positions.size());
  for (std::size_t i = 0; i < after->normals.size(); ++i) CHECK(length(after->normals[i]) == Approx(1));
  Json single = warp_scene();
  const Point vertex = before->positions[40];
  single["points"] = make("point", {{"position", {vertex.x, vertex.y, vertex.z}}});
  require_close(after->positions[40], warped({{"generators", three}, {"softening", 0.4}}, single)[0]);
}

TEST_CASE("A zero generator does nothing and a pure direction has no place to warp from") {
  Json nodes = warp_scene();
  nodes["zero"] = make("point_pair", {{"direction", {0, 0, 0}}});
  nodes["direction"] = make("direction");
  CHECK(warped({{"generators", {from("zero")}}}, nodes) == graph_of(nodes).all<Point>("points"));
  CHECK(warped({{"generators", {from("a"), from("zero")}}}, nodes) == warped({{"generators", {from("a")}}}, nodes));
  nodes["warped"] = make("warp", {{"shape", from("points")}, {"generators", {from("a"), from("direction")}}});
  CHECK(codes(graph_of(nodes).problems("warped")) == std::multiset<std::string>{"degenerate warped.generators"});
}
