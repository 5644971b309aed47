// Copies of shapes: with an image in a mirror, in a row, around an axis and along a curve.

#include "tests/nodes/mesh_measures.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Half a torus, open where it ends in the plane x = 0, a hair off it.
Json half_ring(double off) {
  return {{"axis", make("line")},
          {"ring", make("circle", {{"center", {off, 2, 0}}, {"normal", {1, 0, 0}}, {"radius", 0.5}})},
          {"turn", make("range", {{"from", 0}, {"to", 180}, {"count", 33}})},
          {"rings", make("rotate", {{"shape", from("ring")}, {"axis", from("axis")}, {"angle", from("turn")}})},
          {"half", make("surface", {{"shape", from("rings")}, {"segments", 24}})},
          {"plane", make("plane", {{"normal", {1, 0, 0}}})}};
}

}  // namespace

TEST_CASE("Half a ring and its image are one closed ring") {
  for (const double off : {0.0, 1e-8}) {
    Json nodes = half_ring(off);
    nodes["it"] = make("mirror", {{"shape", from("half")}, {"mirror", from("plane")}});
    CatalogueGraph graph = graph_of(nodes);
    const SharedMesh half = graph.one<SharedMesh>("half"), whole = graph.one<SharedMesh>("it");
    const Measures before = measures_of(*half), after = measures_of(*whole);
    CAPTURE(off);
    CHECK_FALSE(before.closed);
    CHECK(after.closed);
    CHECK(after.euler == 0);
    CHECK(after.volume > 0);
    CHECK(after.triangles == 2 * before.triangles);
    CHECK(after.area == Approx(2 * before.area).epsilon(1e-6));
    // Both borders are shared, not doubled.
    CHECK(whole->positions.size() == 2 * half->positions.size() - 2 * 24);
  }
  Json apart = half_ring(1e-3);
  apart["it"] = make("mirror", {{"shape", from("half")}, {"mirror", from("plane")}});
  CHECK_FALSE(measures_of(*graph_of(apart).one<SharedMesh>("it")).closed);
}

TEST_CASE("A box on a mirror loses the wall and keeps its edges sharp") {
  const Json nodes = {{"box", make("box_mesh", {{"center", {0, 0, 0.5}}, {"segments", 3}})},
                      {"plane", make("plane")},
                      {"it", make("mirror", {{"shape", from("box")}, {"mirror", from("plane")}})}};
  const Measures measures = measures_of(*graph_of(nodes).one<SharedMesh>("it"));
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.volume == Approx(2).epsilon(1e-13));
  CHECK(measures.area == Approx(10).epsilon(1e-13));
  CHECK(measures.triangles == 2 * 5 * 18);
}

TEST_CASE("Halves that meet in a ridge have a normal each at one place") {
  // A slope that leans by 45 degrees out of the mirror x = 0.
  const Json nodes = {
      {"g", make("grid", {{"center", {1, 0, 1}}, {"u_vector", {1, 0, -1}}, {"count_u", 3}, {"count_v", 3}})},
      {"slope", make("surface", {{"shape", from("g")}})},
      {"plane", make("plane", {{"normal", {1, 0, 0}}})},
      {"it", make("mirror", {{"shape", from("slope")}, {"mirror", from("plane")}})}};
  const SharedMesh roof = graph_of(nodes).one<SharedMesh>("it");
  CHECK(roof->positions.size() == 18);
  CHECK(measures_of(*roof).vertices == 15);
  for (std::size_t i = 0; i < roof->normals.size(); ++i) {
    CHECK(std::abs(std::abs(roof->normals[i].x) - std::sqrt(0.5)) < 1e-6);
  }
}

TEST_CASE("A mirror that touches nothing gives two pieces, an empty mesh an empty one") {
  const Json nodes = {{"ball", make("sphere_mesh", {{"center", {0, 0, 3}}, {"segments", 12}, {"rings", 6}})},
                      {"plane", make("plane")},
                      {"it", make("mirror", {{"shape", from("ball")}, {"mirror", from("plane")}})},
                      {"same", make("list", {{"items", {{0, 0, 0}, {0, 0, 0}}}})},
                      {"none", make("tube", {{"shape", from("same")}})},
                      {"nothing", make("mirror", {{"shape", from("none")}, {"mirror", from("plane")}})}};
  CatalogueGraph graph = graph_of(nodes);
  const Measures ball = measures_of(*graph.one<SharedMesh>("ball")), both = measures_of(*graph.one<SharedMesh>("it"));
  CHECK(both.euler == 4);
  CHECK(both.volume == Approx(2 * ball.volume).epsilon(1e-12));
  CHECK(graph.one<SharedMesh>("nothing")->triangles.empty());
}

TEST_CASE("The image of a mesh in a sphere lies where the inversion takes it") {
  const Json nodes = {{"ball", make("sphere_mesh", {{"center", {0, 0, 3}}, {"segments", 12}, {"rings", 6}})},
                      {"mirror", make("sphere", {{"radius", 2}})},
                      {"it", make("mirror", {{"shape", from("ball")}, {"mirror", from("mirror")}})}};
  CatalogueGraph graph = graph_of(nodes);
  const SharedMesh ball = graph.one<SharedMesh>("ball"), both = graph.one<SharedMesh>("it");
  // Of the vertex on the mirror there are two, since the halves meet in a ridge there.
  REQUIRE(both->positions.size() == 2 * ball->positions.size());
  CHECK(measures_of(*both).volume > measures_of(*ball).volume);
  std::size_t image = ball->positions.size();
  for (std::size_t i = 0; i < ball->positions.size(); ++i) {
    const Vector p = to_vector(ball->positions[i]);
    require_close(both->positions[image++], to_point((4 / squared_length(p)) * p));
  }
}

TEST_CASE("Copies in a row are a step apart, of every kind of shape") {
  const Json nodes = {{"p", make("point", {{"position", {1, 2, 3}}})},
                      {"c", make("circle", {{"radius", 0.5}})},
                      {"box", make("box_mesh", {{"segments", 1}})},
                      {"points", make("array", {{"shape", from("p")}, {"step", {0, 0.5, 0}}, {"count", 4}})},
                      {"circles", make("array", {{"shape", from("c")}, {"step", {0, 0, 2}}, {"count", 3}})},
                      {"boxes", make("array", {{"shape", from("box")}, {"step", {2, 0, 0}}, {"count", 7}})},
                      {"lattice", make("array", {{"shape", from("boxes")}, {"step", {0, 2, 0}}, {"count", 2}})},
                      {"all", make("merge", {{"meshes", Json::array({from("lattice")})}})}};
  CatalogueGraph graph = graph_of(nodes);
  const std::vector<Point> points = graph.all<Point>("points");
  REQUIRE(points.size() == 4);
  CHECK(points[0] == Point{1, 2, 3});
  for (std::size_t i = 0; i < 4; ++i) require_close(points[i], {1, 2 + 0.5 * static_cast<double>(i), 3});
  CHECK(graph.json("circles")["values"][2]["center"][2] == Approx(4));
  CHECK(graph.planned("lattice").outputs[0].axes == Axes{{"boxes", 7, false}, {"lattice", 2, false}});
  const Measures measures = measures_of(*graph.one<SharedMesh>("all"));
  CHECK(measures.volume == Approx(14).epsilon(1e-12));
  CHECK(measures.euler == 28);
}

TEST_CASE("A full turn of copies closes, a part of a turn ends at its angle") {
  Json nodes = {{"axis", make("line", {{"point", {1, 0, 0}}})},
                {"p", make("point", {{"position", {3, 0, 1}}})},
                {"it", make("array_around", {{"shape", from("p")}, {"axis_line", from("axis")}, {"count", 8}})}};
  CatalogueGraph closed = graph_of(nodes);
  const std::vector<Point> ring = closed.all<Point>("it");
  CHECK(closed.planned("it").outputs[0].axes == Axes{{"it", 8, true}});
  for (std::size_t i = 0; i < 8; ++i) {
    const double angle = 2 * 3.14159265358979323846 * static_cast<double>(i) / 8;
    require_close(ring[i], {1 + 2 * std::cos(angle), 2 * std::sin(angle), 1});
  }
  nodes["it"]["inputs"].update({{"closed", false}, {"angle", 90}, {"count", 3}});
  const std::vector<Point> quarter = graph_of(nodes).all<Point>("it");
  require_close(quarter[1], {1 + std::sqrt(2.0), std::sqrt(2.0), 1});
  require_close(quarter[2], {1, 2, 1});
  nodes["it"]["inputs"]["count"] = 1;
  CHECK(graph_of(nodes).all<Point>("it") == std::vector<Point>{{3, 0, 1}});
}

namespace {

/// Where the ends of a small cross of three axes come to at each point of a curve.
struct Cross {
  std::vector<Point> origin, x, y, z;
};

Cross along(Json nodes, const Json& more) {
  const std::array<const char*, 4> names = {"o", "x", "y", "z"};
  const Json places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::array<std::vector<Point>, 4> ends;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string name = names[k];
    nodes[name + "_at"] = make("point", {{"position", places[k]}});
    Json inputs = {{"shape", from(name + "_at")}, {"curve", from("way")}};
    inputs.update(more);
    nodes[name] = make("array_along", inputs);
  }
  CatalogueGraph graph = graph_of(nodes);
  for (std::size_t k = 0; k < 4; ++k) ends[k] = graph.all<Point>(names[k]);
  return {ends[0], ends[1], ends[2], ends[3]};
}

Vector way(const Point& from, const Point& to) { return to_vector(to) - to_vector(from); }

}  // namespace

TEST_CASE("Copies along a curve stand on it, upright to each other and never mirrored") {
  const Json helix = {{"way", make("helix", {{"radius", 2}, {"pitch", 1}, {"count", 200}})}};
  const std::vector<Point> points = graph_of(helix).all<Point>("way");
  for (const char* frames : {"steady", "curvature", "upright"}) {
    const Cross cross_at = along(helix, {{"frames", frames}});
    for (std::size_t i = 0; i < points.size(); ++i) {
      require_close(cross_at.origin[i], points[i]);
      const Vector x = way(points[i], cross_at.x[i]), y = way(points[i], cross_at.y[i]),
                   z = way(points[i], cross_at.z[i]);
      require_close(cross(x, y), z, 1e-9);
      CHECK(length(x) == Approx(1).epsilon(1e-9));
      const Vector to_axis = normalized({-points[i].x, -points[i].y, 0});
      const Vector level = cross(Vector{0, 0, 1}, -to_axis);
      // The slope of the helix: pitch over 2 pi radius.
      const Vector tangent = normalized(level + Vector{0, 0, 1 / (4 * 3.14159265358979323846)});
      if (std::string(frames) == "upright") {
        require_close(z, Vector{0, 0, 1}, 1e-9);
        require_close(x, level, 2e-3);
      } else {
        require_close(x, tangent, 2e-3);
      }
      if (std::string(frames) == "curvature" && i > 0 && i + 1 < points.size()) require_close(z, to_axis, 2e-3);
    }
  }
}

TEST_CASE("Steady copies start near up, and around a flat ring all of them stand up") {
  const Json ring = {{"round", make("circle", {{"radius", 3}})},
                     {"way", make("sample", {{"shape", from("round")}, {"count", 40}})}};
  const Cross flat = along(ring, Json::object());
  for (std::size_t i = 0; i < 40; ++i) require_close(way(flat.origin[i], flat.z[i]), Vector{0, 0, 1}, 1e-9);
  // Neighbors on a closed space curve differ by little, around the seam too.
  const Json knot = {{"corners", make("list", {{"items", {{2, 0, 1}, {0, 2, -1}, {-2, 0, 1}, {0, -2, -1}}}})},
                     {"way", make("curve", {{"points", from("corners")}, {"closed", true}, {"count", 200}})}};
  const Cross closed = along(knot, Json::object());
  for (std::size_t i = 0; i < 200; ++i) {
    const std::size_t next = (i + 1) % 200;
    CHECK(dot(way(closed.origin[i], closed.z[i]), way(closed.origin[next], closed.z[next])) > 0.97);
  }
}

TEST_CASE("Copies along a straight curve, along up and at one point have whole frames") {
  const auto ways = [](const Json& items) { return Json{{"way", make("list", {{"items", items}})}}; };
  for (const char* frames : {"steady", "curvature", "upright"}) {
    for (const Json& items : {Json{{0, 0, 0}, {0, 0, 1}, {0, 0, 5}}, Json{{0, 0, 0}, {1, 1, 0}}, Json{{1, 2, 3}},
                              Json{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}}) {
      CAPTURE(frames, items.dump());
      const Cross cross_at = along(ways(items), {{"frames", frames}});
      for (std::size_t i = 0; i < items.size(); ++i) {
        const Vector x = way(cross_at.origin[i], cross_at.x[i]), y = way(cross_at.origin[i], cross_at.y[i]),
                     z = way(cross_at.origin[i], cross_at.z[i]);
        require_close(cross(x, y), z, 1e-9);
        CHECK(length(z) == Approx(1).epsilon(1e-9));
      }
    }
  }
  Json far = ways({{0, 0, 0}, {1e30, 0, 0}});
  far["p"] = make("point");
  far["it"] = make("array_along", {{"shape", from("p")}, {"curve", from("way")}});
  const Problems problems = graph_of(far).problems("it");
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].code == "degenerate");
  CHECK(problems[0].port == "curve");
}
