// Contours in which planes cut meshes.

#include "geometry/contours.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

constexpr double full_turn = 2 * 3.14159265358979323846;

Json with_slice(Json nodes, Json inputs, const std::string& of = "shape") {
  inputs["shape"] = from(of);
  nodes["it"] = make("slice", std::move(inputs));
  return nodes;
}

/// Twice the area around points of a plane z = const, positive counter-clockwise.
double turned_area(const std::vector<Point>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

const Json fine_ball = {{"shape", make("sphere_mesh", {{"radius", 2}, {"segments", 256}, {"rings", 128}})}};

}  // namespace

TEST_CASE("Slices of a ball are circles, at every height and along every normal") {
  for (const double height : {-1.5, -0.3, 0.0, 1.0, 1.9}) {
    for (const Json& normal : {Json{0, 0, 1}, Json{1, 2, -2}}) {
      CAPTURE(height, normal.dump());
      CatalogueGraph graph = graph_of(with_slice(fine_ball, {{"height", height}, {"normal", normal}}));
      const double radius = std::sqrt(4 - height * height);
      CHECK(graph.one<double>("it.contours") == 1);
      CHECK(graph.one<double>("it.length") == Approx(full_turn * radius).epsilon(2e-3));
      CHECK(graph.one<double>("it.area") == Approx(full_turn / 2 * radius * radius).epsilon(4e-3));
      const Vector up = normalized({normal[0], normal[1], normal[2]});
      for (const Point& p : graph.all<Point>("it")) {
        CHECK(dot(to_vector(p), up) == Approx(height).margin(1e-12));
        CHECK(length(to_vector(p)) == Approx(2).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("The area of slices over all heights is the volume") {
  Json nodes = with_slice(fine_ball, {{"height", from("heights")}, {"count", 8}});
  nodes["heights"] = make("range", {{"from", -1.995}, {"to", 1.995}, {"count", 400}});
  double sum = 0;
  for (const double area : graph_of(nodes).all<double>("it.area")) sum += 0.01 * area;
  CHECK(sum == Approx(full_turn * 16 / 3).epsilon(2e-3));
}

TEST_CASE("A slice of a box has its four corners, runs around it and keeps them among any number of points") {
  const Json box = {{"shape", make("box_mesh", {{"size", {3, 2, 1}}, {"segments", 1}})}};
  for (const int count : {8, 9, 64, 257}) {
    CAPTURE(count);
    CatalogueGraph graph = graph_of(with_slice(box, {{"count", count}}));
    CHECK(graph.one<double>("it.area") == Approx(6).epsilon(1e-14));
    CHECK(graph.one<double>("it.length") == Approx(10).epsilon(1e-14));
    const std::vector<Point> points = graph.all<Point>("it");
    CHECK(points.size() == static_cast<std::size_t>(count));
    CHECK(turned_area(points) == Approx(6).epsilon(1e-13));
    CHECK(graph.planned("it").outputs[0].axes == Axes{{"it", static_cast<std::size_t>(count), true}});
  }
  // With fewer points than corners they are at even lengths.
  const std::vector<Point> few = graph_of(with_slice(box, {{"count", 4}})).all<Point>("it");
  for (const Point& p : few) CHECK((std::abs(std::abs(p.x) - 1.5) < 1e-12 || std::abs(std::abs(p.y) - 1) < 1e-12));
}

TEST_CASE("A plane in the bottom of a box cuts nothing, one in its top does, and none beyond") {
  const Json box = {{"shape", make("box_mesh", {{"segments", 2}})}};
  const auto area_at = [&](double height) {
    return graph_of(with_slice(box, {{"height", height}})).one<double>("it.area");
  };
  CHECK(area_at(-0.5) == 0);
  CHECK(area_at(0.5) == Approx(1).epsilon(1e-14));
  CHECK(area_at(0) == Approx(1).epsilon(1e-14));
  CHECK(area_at(0.6) == 0);
  CatalogueGraph beyond = graph_of(with_slice(box, {{"height", 7}, {"count", 5}}));
  CHECK(beyond.one<double>("it.contours") == 0);
  CHECK(beyond.one<double>("it.length") == 0);
  CHECK(beyond.all<Point>("it") == std::vector<Point>(5, Point::at_infinity()));
}

TEST_CASE("A ring cut across has a hole, and cut along two contours side by side") {
  const Json ring = {
      {"shape", make("torus_mesh", {{"major_radius", 2}, {"minor_radius", 0.5}, {"segments", 256}, {"sides", 128}})}};
  CatalogueGraph across = graph_of(with_slice(ring, {{"contour", 0}}));
  CHECK(across.one<double>("it.contours") == 2);
  CHECK(across.one<double>("it.area") == Approx(full_turn / 2 * (2.5 * 2.5 - 1.5 * 1.5)).epsilon(2e-3));
  CHECK(across.one<double>("it.length") == Approx(full_turn * 2.5).epsilon(2e-3));
  CHECK(turned_area(across.all<Point>("it")) > 0);
  CatalogueGraph hole = graph_of(with_slice(ring, {{"contour", 1}}));
  CHECK(hole.one<double>("it.length") == Approx(full_turn * 1.5).epsilon(2e-3));
  CHECK(turned_area(hole.all<Point>("it")) < 0);
  CatalogueGraph along = graph_of(with_slice(ring, {{"normal", {1, 0, 0}}}));
  CHECK(along.one<double>("it.contours") == 2);
  CHECK(along.one<double>("it.area") == Approx(2 * full_turn / 2 * 0.25).epsilon(2e-3));
  // All contours over an axis of their numbers; there is no third.
  Json nodes = with_slice(ring, {{"contour", from("numbers")}, {"count", 16}});
  nodes["numbers"] = make("range", {{"from", 0}, {"to", 2}, {"count", 3}});
  CatalogueGraph all = graph_of(nodes);
  const std::vector<double> lengths = all.all<double>("it.length");
  CHECK(lengths[0] > lengths[1]);
  CHECK(lengths[2] == 0);
  CHECK(all.planned("it").outputs[0].axes == Axes{{"numbers", 3, false}, {"it", 16, true}});
}

TEST_CASE("A contour of an open sheet has two ends and is run there and back") {
  const Json sheet = {
      {"g", make("grid", {{"u_vector", {2, 0, 0}}, {"v_vector", {0, 0, 1}}, {"count_u", 9}, {"count_v", 4}})},
      {"shape", make("surface", {{"shape", from("g")}})}};
  CatalogueGraph graph = graph_of(with_slice(sheet, {{"height", 0.1}, {"count", 40}}));
  CHECK(graph.one<double>("it.contours") == 1);
  CHECK(graph.one<double>("it.length") == Approx(4).epsilon(1e-14));
  CHECK(graph.one<double>("it.area") == 0);
  double least = 0, most = 0;
  for (const Point& p : graph.all<Point>("it")) {
    CHECK(p.y == 0);
    least = std::min(least, p.x);
    most = std::max(most, p.x);
  }
  CHECK(least == Approx(-2));
  CHECK(most == Approx(2));
}

TEST_CASE("Triangles that share one edge, or turn against each other, still give contours") {
  constexpr std::uint32_t fins = 2000;
  Mesh fan;
  Column<Point> places(fins + 2);
  places.set(0, {0, 0, -1});
  places.set(1, {0, 0, 1});
  for (std::uint32_t k = 0; k < fins; ++k) {
    places.set(k + 2, {std::cos(0.003 * k), std::sin(0.003 * k), 0.5});
    fan.triangles.push_back(k % 2 == 0 ? std::array<std::uint32_t, 3>{0, 1, k + 2}
                                       : std::array<std::uint32_t, 3>{1, 0, k + 2});
  }
  fan.positions = std::move(places);
  const Cancel cancel;
  const std::vector<Contour> contours = contours_of(fan, {0, 0, 1}, 0, cancel);
  double total = 0;
  for (const Contour& contour : contours) {
    CHECK_FALSE(contour.points.empty());
    total += contour.length;
  }
  // Each fin is cut from its edge to two thirds of the way out.
  CHECK(total == Approx(fins * 2.0 / 3).epsilon(1e-9));
}

TEST_CASE("An empty mesh has no contours") {
  const Json empty = {{"same", make("list", {{"items", {{0, 0, 0}, {0, 0, 0}}}})},
                      {"shape", make("tube", {{"shape", from("same")}})}};
  CHECK(graph_of(with_slice(empty, Json::object())).one<double>("it.contours") == 0);
}
