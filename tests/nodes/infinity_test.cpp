// Boosts send points to infinity; no number that is none ever stands on a wire.

#include <catch2/catch.hpp>

#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A pair at the origin along x: at amount 1 its pole is (-1, 0, 0).
const Json pair = make("point_pair", {{"direction", {1, 0, 0}}});

Json boost(const std::string& shape, Json amount = 1) {
  return make("boost", {{"shape", from(shape)}, {"generator", from("pair")}, {"amount", std::move(amount)}});
}

}  // namespace

TEST_CASE("The point at the pole of a boost is shown as null, and comes back") {
  CatalogueGraph graph = graph_of({{"pair", pair},
                                   {"p", make("list", {{"items", {{-1, 0, 0}, {1, 0, 0}}}})},
                                   {"gone", boost("p")},
                                   {"back", boost("gone", -1)}});
  const Json gone = graph.json("gone");
  CHECK(gone["values"][0].is_null());
  require_close(graph.all<Point>("gone")[1], Point{0.5, 0, 0});
  CHECK(graph.all<Point>("gone")[0] == Point::at_infinity());
  for (const Point& p : graph.all<Point>("back")) CHECK(is_finite(p));
  require_close(graph.all<Point>("back")[0], Point{-1, 0, 0});
}

TEST_CASE("A circle through the pole of a boost becomes a line") {
  CatalogueGraph graph = graph_of({{"pair", pair}, {"ring", make("circle")}, {"moved", boost("ring")}});
  const Json line = graph.json("moved")["values"][0];
  REQUIRE(line.value("line", false));
  CHECK(line["point"][0].get<double>() == Approx(0.5));
}

TEST_CASE("Triangles of a mesh that reach infinity are left out with a warning") {
  // The segments start at (radius, 0, 0), so with an even number of them one vertex is the pole itself.
  CatalogueGraph graph = graph_of({{"pair", pair},
                                   {"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}})},
                                   {"moved", boost("ball")},
                                   {"tame", boost("ball", 0.25)}});
  const auto before = graph.one<SharedMesh>("ball"), after = graph.one<SharedMesh>("moved");
  REQUIRE(graph.warnings().size() == 1);
  CHECK(graph.warnings()[0].code == "at-infinity");
  CHECK(after->triangles.size() < before->triangles.size());
  CHECK(after->triangles.size() > before->triangles.size() / 2);
  CHECK(after->normals.size() == after->positions.size());
  for (std::size_t i = 0; i < after->positions.size(); ++i) {
    CHECK(is_finite(after->positions[i]));
    CHECK(is_finite(after->normals[i]));
  }
  for (const auto& triangle : after->triangles) {
    for (const std::uint32_t vertex : triangle) CHECK(vertex < after->positions.size());
  }
  if (!after->tile_ends.empty()) CHECK(after->tile_ends.back() == after->triangles.size());
  CHECK(graph.one<SharedMesh>("tame")->triangles.size() == before->triangles.size());
  CHECK(graph.warnings().empty());
}

TEST_CASE("A surface through infinity is clipped inside the clip radius with a warning, or fails as asked") {
  const auto graph_with = [](const char* at_infinity) {
    return graph_of(
        {{"pair", pair},
         {"ring", make("circle")},
         {"k", make("range", {{"from", 0}, {"to", 2}, {"count", 41}})},
         {"moved", boost("ring", from("k"))},
         {"slid", make("translate", {{"shape", from("moved")}, {"vector", from("up")}})},
         {"up", make("vector", {{"z", from("k")}})},
         {"skin", make("surface", {{"shape", from("slid")}, {"at_infinity", at_infinity}, {"clip_radius", 6}})}});
  };
  CatalogueGraph graph = graph_with("clip");
  const auto mesh = graph.one<SharedMesh>("skin");
  REQUIRE(graph.warnings().size() == 1);
  CHECK(graph.warnings()[0].code == "at-infinity");
  const std::string sentence = told(graph.warnings()[0], graph.planned("skin").consumed);
  CHECK(sentence.find("reaches infinity, first at index ") != std::string::npos);
  CHECK(sentence.ends_with(" of axis k"));
  REQUIRE_FALSE(mesh->triangles.empty());
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) CHECK(length(to_vector(mesh->positions[i])) <= 6 + 1e-9);
  CHECK(codes(graph_with("fail").problems("skin")) == std::multiset<std::string>{"at-infinity skin.at_infinity"});
}

TEST_CASE("A tube along a line ends inside the clip radius") {
  CatalogueGraph graph =
      graph_of({{"axis", make("line", {{"point", {0, 1, 0}}, {"direction", {1, 1, 0}}})},
                {"pipe", make("tube", {{"shape", from("axis")}, {"radius", 0.1}, {"clip_radius", 5}})}});
  const auto mesh = graph.one<SharedMesh>("pipe");
  REQUIRE_FALSE(mesh->triangles.empty());
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) CHECK(length(to_vector(mesh->positions[i])) <= 5.2);
}

TEST_CASE("A point at infinity survives being measured for a surface and never reaches a file") {
  CatalogueGraph graph = graph_of({{"pair", pair},
                                   {"sheet", make("grid", {{"center", {-1, 0, 0}}, {"count_u", 9}, {"count_v", 9}})},
                                   {"moved", boost("sheet")},
                                   {"skin", make("surface", {{"shape", from("moved")}, {"clip_radius", 20}})},
                                   {"out", make("export", {{"model", {from("skin"), from("moved")}}})}});
  CHECK(graph.one<SharedMesh>("skin")->positions.size() > 20);
  CHECK(graph.one<SharedFile>("out")->bytes->size() > 1000);
}
