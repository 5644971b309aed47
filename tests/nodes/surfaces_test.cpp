#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

/// The nodes with a `measure` of "skin" as the node "m".
CatalogueGraph measured(Json nodes) {
  nodes["m"] = make("measure", {{"model", from("skin")}});
  return graph_of(nodes);
}

Json torus_points(bool closed_rows, bool closed_columns) {
  return {{"u", make("range", {{"count", 40}, {"closed", closed_rows}})},
          {"v", make("range", {{"count", 30}, {"closed", closed_columns}})},
          {"far", make("expression", {{"formula", "2 + 0.5 * cos(2 * pi * x)"}, {"x", from("v")}})},
          {"x", make("expression", {{"formula", "y * cos(2 * pi * x)"}, {"x", from("u")}, {"y", from("far")}})},
          {"y", make("expression", {{"formula", "y * sin(2 * pi * x)"}, {"x", from("u")}, {"y", from("far")}})},
          {"z", make("expression", {{"formula", "0.5 * sin(2 * pi * x)"}, {"x", from("v")}})},
          {"place", make("vector", {{"x", from("x")}, {"y", from("y")}, {"z", from("z")}})},
          {"origin", make("point")},
          {"points", make("translate", {{"shape", from("origin")}, {"vector", from("place")}})},
          {"skin", make("surface", {{"shape", from("points")}, {"over", "u"}, {"along", "v"}})}};
}

}  // namespace

TEST_CASE("A boosted ring lies on a horn torus") {
  for (const auto& [radius, height] : {std::pair{1.0, 1.5}, {1.0, 0.5}, {2.0, 2.0}}) {
    CatalogueGraph graph = graph_of(
        {{"ring", make("circle", {{"radius", radius}})},
         {"tau", make("point_pair", {{"position", {0, 0, height}}, {"direction", {0, 0, -2}}})},
         {"k", make("range", {{"count", 33}, {"to", 1}})},
         {"boosted", make("boost", {{"shape", from("ring")}, {"generator", from("tau")}, {"amount", from("k")}})},
         {"skin", make("surface", {{"shape", from("boosted")}, {"segments", 64}})}});
    const auto mesh = graph.one<SharedMesh>("skin");
    const double a = (radius * radius + height * height) / (2 * radius);
    REQUIRE(mesh->positions.size() == 33 * 64);
    for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
      const Point p = mesh->positions[i];
      const double across = std::hypot(p.x, p.y) - a, up = p.z - height;
      CHECK(std::abs(across * across + up * up - a * a) < 1e-11 * a * a);
    }
  }
}

TEST_CASE("Surfaces have the Euler number that the closure of their axes promises") {
  CHECK(measured(torus_points(true, true)).one<double>("m.euler") == 0);
  CHECK(measured(torus_points(false, true)).one<double>("m.euler") == 0);
  Json sheet = torus_points(false, false);
  sheet["v"]["inputs"]["to"] = 0.75;
  sheet["u"]["inputs"]["to"] = 0.75;
  CHECK(measured(sheet).one<double>("m.euler") == 1);
  // Circles of a sphere, from pole to pole.
  CatalogueGraph sphere =
      measured({{"t", make("range", {{"to", 1}, {"count", 33}})},
                {"r", make("expression", {{"formula", "sin(pi * x) * (x > 0 && x < 1)"}, {"x", from("t")}})},
                {"h", make("expression", {{"formula", "-cos(pi * x)"}, {"x", from("t")}})},
                {"up", make("vector", {{"z", from("h")}})},
                {"flat", make("circle", {{"radius", from("r")}})},
                {"circles", make("translate", {{"shape", from("flat")}, {"vector", from("up")}})},
                {"skin", make("surface", {{"shape", from("circles")}, {"segments", 48}})}});
  CHECK(sphere.one<double>("m.euler") == 2);
  CHECK(std::abs(sphere.one<double>("m.volume")) == Approx(4 * 3.14159265 / 3).epsilon(0.02));
}

TEST_CASE("The order of a surface's axes is chosen by over and along") {
  Json nodes = torus_points(true, true);
  const double volume = measured(nodes).one<double>("m.volume");
  nodes["skin"]["inputs"] = {{"shape", from("points")}, {"over", "v"}, {"along", "u"}};
  CHECK(measured(nodes).one<double>("m.volume") == Approx(-volume));
  CHECK(std::abs(volume) == Approx(2 * 9.8696 * 2 * 0.25).epsilon(0.02));
}

TEST_CASE("Tubes are closed around closed curves and capped at the ends of open ones") {
  const auto tube = [](bool closed) {
    return measured({{"ring", make("circle", {{"radius", 2}})},
                     {"arc", make("sample", {{"shape", from("ring")}, {"count", 64}, {"closed", closed}})},
                     {"skin", make("tube", {{"shape", from("arc")}, {"radius", 0.1}, {"sides", 12}})}});
  };
  CHECK(tube(true).one<double>("m.euler") == 0);
  CatalogueGraph ring =
      measured({{"ring", make("circle", {{"radius", 2}})},
                {"skin", make("tube", {{"shape", from("ring")}, {"radius", 0.1}, {"segments", 128}, {"sides", 24}})}});
  CHECK(ring.one<double>("m.euler") == 0);
  CHECK(ring.one<double>("m.volume") == Approx(2 * 9.8696 * 2 * 0.01).epsilon(0.02));
  CatalogueGraph straight =
      measured({{"line", make("line")},
                {"arc", make("sample", {{"shape", from("line")}, {"count", 8}, {"closed", false}, {"length", 4}})},
                {"skin", make("tube", {{"shape", from("arc")}, {"radius", 0.1}, {"sides", 32}})}});
  CHECK(straight.one<double>("m.euler") == 2);
  CHECK(straight.one<double>("m.volume") == Approx(4 * 3.14159265 * 0.01).epsilon(0.02));
}

TEST_CASE("A patch is the surface of its grid under the blend of its generators") {
  Json nodes = {{"a", make("point_pair", {{"position", {-1, -1, 0}}, {"direction", {0.3, 0, 1}}})},
                {"b", make("point_pair", {{"position", {1, -1, 0}}, {"direction", {0, 0.4, -0.8}}})},
                {"c", make("point_pair", {{"position", {-1, 1, 0}}, {"direction", {0.1, -0.3, -0.5}}})},
                {"d", make("point_pair", {{"position", {1, 1, 0}}, {"direction", {-0.2, 0.1, 0.6}}})},
                {"sheet", make("grid", {{"count_u", 7}, {"count_v", 5}})}};
  const Json corners = {{"a", from("a")}, {"b", from("b")}, {"c", from("c")}, {"d", from("d")}};
  for (const char* rule : {"exact", "paper"}) {
    nodes["blend"] = make("interpolate", corners);
    nodes["blend"]["inputs"].update({{"u", from("sheet.u")}, {"v", from("sheet.v")}});
    nodes["moved"] =
        make("boost", {{"shape", from("sheet")}, {"generator", from("blend")}, {"amount", 0.5}, {"rule", rule}});
    nodes["skin"] = make("surface", {{"shape", from("moved")}, {"over", "u"}, {"along", "v"}});
    nodes["patch"] = make("patch", corners);
    nodes["patch"]["inputs"].update({{"amount", 0.5}, {"count_u", 7}, {"count_v", 5}, {"rule", rule}});
    CatalogueGraph graph = graph_of(nodes);
    const auto skin = graph.one<SharedMesh>("skin"), patch = graph.one<SharedMesh>("patch");
    CHECK(patch->triangles == skin->triangles);
    REQUIRE(patch->positions.size() == skin->positions.size());
    for (std::size_t i = 0; i < skin->positions.size(); ++i) require_close(patch->positions[i], skin->positions[i]);
  }
}

TEST_CASE("Surfaces need two axes of points, and say so") {
  CatalogueGraph graph = graph_of({{"ring", make("circle")},
                                   {"arc", make("sample", {{"shape", from("ring")}})},
                                   {"skin", make("surface", {{"shape", from("arc")}})}});
  CHECK(codes(graph.static_problems()) == std::multiset<std::string>{"axis-mismatch skin.shape"});
}
