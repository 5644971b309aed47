// thicken, offset, cap and printability; and the objects of the gallery that are made of them.

#include <fstream>
#include <numbers>

#include "geometry/contacts.h"
#include "geometry/measure.h"
#include "geometry/solid.h"
#include "geometry/welded_mesh.h"
#include "tests/support/catalogue.h"
#include "tests/support/never_stopped.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json coarse_ball = make("sphere_mesh", {{"segments", 24}, {"rings", 12}});

Json read_object(const std::string& id) {
  std::ifstream file(std::string(DINI_SOURCE_DIR) + "/examples/" + id + ".json");
  return Json::parse(file);
}

/// The nodes of a document with values instead of its parameters, and half of the points along its long ranges.
Json with_values(Json nodes, const Json& values) {
  for (auto& [id, node] : nodes.items()) {
    Json& inputs = node["inputs"];
    const bool is_long = inputs.contains("count") && inputs["count"].is_number() && inputs["count"] > 60;
    if (is_long) inputs["count"] = (inputs["count"].get<int>() + 1) / 2;
    for (auto& [port, input] : node["inputs"].items()) {
      if (input.is_object() && input.contains("parameter")) {
        input = Json(values[input["parameter"].get<std::string>()]);
      }
    }
  }
  return nodes;
}

/// Values of the parameters of a document within their bounds: the least, the greatest, then random ones.
Json setting(const Json& document, int round, RandomElements& random) {
  Json values;
  for (const auto& [name, parameter] : document["parameters"].items()) {
    const double low = parameter["min"], high = parameter["max"];
    const double value = round == 0 ? low : round == 1 ? high : low + (high - low) * (0.5 + random.number(0.5));
    const bool whole = parameter["type"] == "integer";
    values[name] = whole ? Json(static_cast<std::int64_t>(std::lround(value))) : Json(value);
  }
  return values;
}

/// What is promised of an object at every setting.
struct Promise {
  const char* id;
  const char* mesh;          ///< the node whose mesh is the object
  std::optional<int> euler;  ///< nothing where holes come and go, and it is even
};

void require_solid(const Promise& promise, const SharedMesh& mesh) {
  const Measures measures = measure(*mesh, never_stopped);
  CHECK(measures.closed);
  CHECK(measures.boundary_edges == 0);
  CHECK(2 * measures.edges == 3 * measures.triangles);
  CHECK(measures.volume > 0);
  CHECK(measures.euler % 2 == 0);
  if (promise.euler) CHECK(measures.euler == *promise.euler);
}

}  // namespace

TEST_CASE("Thicken makes a solid of a surface and says how thick it may be") {
  CatalogueGraph graph = graph_of({{"ball", coarse_ball},
                                   {"thin", make("thicken", {{"shape", from("ball")}, {"thickness", 0.3}})},
                                   {"thick", make("thicken", {{"shape", from("ball")}, {"thickness", 2}})},
                                   {"sound", make("printability", {{"model", from("thin")}})}});
  CHECK(graph.one<double>("thin.fits") == 0.3);
  CHECK(graph.warnings().empty());
  CHECK(graph.one<double>("sound.watertight") == 1);
  CHECK(graph.one<double>("sound.components") == 2);
  CHECK(graph.one<double>("sound.self_intersections") == 0);
  CHECK(graph.one<double>("sound.least_thickness") == Approx(0.3).epsilon(0.02));
  CHECK(graph.one<double>("thick.fits") == Approx(1).margin(0.003));
  REQUIRE(graph.warnings().size() == 1);
  CHECK(graph.warnings()[0].code == "self-contact");
  CHECK(graph.warnings()[0].detail.find("would fit") != std::string::npos);
}

TEST_CASE("Thicken looks for contact only when it is asked to") {
  CatalogueGraph graph =
      graph_of({{"ball", coarse_ball},
                {"wall", make("thicken", {{"shape", from("ball")}, {"thickness", 2}, {"find_contact", false}})}});
  CHECK(graph.one<double>("wall.fits") == 2);
  CHECK(graph.warnings().empty());
}

TEST_CASE("The sides of a wall lie where their names say") {
  for (const auto& [side, low, high] :
       {std::tuple{"inside", 0.8, 1.0}, std::tuple{"both", 0.9, 1.1}, std::tuple{"outside", 1.0, 1.2}}) {
    CAPTURE(side);
    const SharedMesh wall =
        graph_of({{"ball", coarse_ball},
                  {"wall", make("thicken", {{"shape", from("ball")}, {"thickness", 0.2}, {"side", side}})}})
            .one<SharedMesh>("wall");
    for (std::size_t i = 0; i < wall->positions.size(); ++i) {
      const double radius = length(to_vector(wall->positions[i]));
      CHECK((radius == Approx(low) || radius == Approx(high)));
    }
  }
}

TEST_CASE("A field takes the wall from one thickness to the other") {
  CatalogueGraph graph = graph_of({{"sheet", make("grid", {{"u_vector", {2, 0, 0}}, {"count_u", 41}, {"count_v", 3}})},
                                   {"skin", make("surface", {{"shape", from("sheet.points")}})},
                                   {"edge", make("plane", {{"point", {-0.5, 0, 0}}, {"normal", {1, 0, 0}}})},
                                   {"behind", make("solid", {{"shape", from("edge")}})},
                                   {"wall", make("thicken", {{"shape", from("skin")},
                                                             {"thickness", 0.1},
                                                             {"side", "outside"},
                                                             {"field", from("behind")},
                                                             {"far_thickness", 0.4},
                                                             {"fade", 1}})}});
  const SharedMesh skin = graph.one<SharedMesh>("skin"), wall = graph.one<SharedMesh>("wall");
  for (std::size_t i = 0; i < skin->positions.size(); ++i) {
    const double x = skin->positions[i].x, way = std::clamp(x + 0.5, 0.0, 1.0);
    const double expected = 0.1 + 0.3 * way * way * (3 - 2 * way);
    CHECK(std::abs(wall->positions[i].z) == Approx(expected).epsilon(1e-12));
  }
  CHECK(measure(*wall, never_stopped).closed);
}

TEST_CASE("Numbers over a mesh make its wall as thick as they say, at each vertex and all around") {
  const Json pipe = {
      {"height", make("range", {{"from", 2}, {"to", 0}, {"count", 9}, {"axis", "height"}})},
      {"angle", make("range", {{"to", 360}, {"count", 30}, {"closed", true}, {"axis", "angle"}})},
      {"up", make("vector", {{"z", from("height")}})},
      {"ring", make("circle")},
      {"rings", make("translate", {{"shape", from("ring")}, {"vector", from("up")}})},
      {"skin", make("surface", {{"shape", from("rings")}, {"segments", 60}})},
      {"both",
       make("expression", {{"formula", "2 + x / 2 + sin(y * pi / 180)"}, {"x", from("height")}, {"y", from("angle")}})},
      {"rising", make("expression", {{"formula", "1 + x"}, {"x", from("height")}})}};
  const auto wall_by = [&](Json inputs) {
    Json nodes = pipe;
    inputs.update({{"shape", from("skin")}, {"thickness", 0.1}, {"side", "outside"}});
    nodes["wall"] = make("thicken", inputs);
    return graph_of(nodes);
  };
  const auto thickness_at = [](const Point& point) { return std::hypot(point.x, point.y) - 1; };

  CatalogueGraph even = wall_by({{"factors", 3}}), along_u = wall_by({{"factors", from("rising")}}),
                 along_v = wall_by({{"factors", from("both")}, {"over", "height"}, {"along", "angle"}});
  const SharedMesh skin = even.one<SharedMesh>("skin");
  for (std::size_t i = 0; i < skin->positions.size(); ++i) {
    const Point at = skin->positions[i];
    CHECK(thickness_at(even.one<SharedMesh>("wall")->positions[i]) == Approx(0.3).epsilon(1e-12));
    CHECK(thickness_at(along_u.one<SharedMesh>("wall")->positions[i]) == Approx(0.1 * (1 + at.z)).epsilon(1e-12));
  }
  // The circle of a surface has twice the samples of the angle: every other vertex is a sample, those between a mean.
  const SharedMesh wall = along_v.one<SharedMesh>("wall");
  for (std::size_t row = 0; row < 9; ++row) {
    for (std::size_t column = 0; column < 60; ++column) {
      const std::size_t i = row * 60 + column;
      const auto sine = [](std::size_t sample) {
        return std::sin(static_cast<double>(sample) * std::numbers::pi / 15);
      };
      const double mean = (sine(column / 2) + sine((column + 1) / 2)) / 2;
      CHECK(thickness_at(wall->positions[i]) == Approx(0.1 * (2 + skin->positions[i].z / 2 + mean)).epsilon(1e-12));
    }
  }
  CHECK(measure(*wall, never_stopped).closed);
}

TEST_CASE("Numbers over a mesh that make no wall are refused where they are") {
  const auto refused = [](const Json& mesh, const Json& inputs) {
    Json wall = {{"shape", from("mesh")}};
    wall.update(inputs);
    CatalogueGraph graph = graph_of({{"shape", make("sphere")},
                                     {"solid", make("solid", {{"shape", from("shape")}})},
                                     {"mesh", mesh},
                                     {"t", make("range", {{"to", 1}, {"count", 5}, {"axis", "t"}})},
                                     {"wall", make("thicken", wall)}});
    return codes(graph.problems("wall"));
  };
  using Codes = std::multiset<std::string>;
  CHECK(refused(coarse_ball, {{"factors", from("t")}}) == Codes{"out-of-range wall.factors"});
  CHECK(refused(coarse_ball, {{"factors", -1}}) == Codes{"out-of-range wall.factors"});
  CHECK(refused(coarse_ball, {{"factors", from("t")}, {"over", "s"}}) == Codes{"axis-mismatch wall.over"});
  CHECK(refused(coarse_ball, {{"factors", from("t")}, {"over", "t"}, {"along", "t"}}) ==
        Codes{"axis-mismatch wall.along"});
  CHECK(refused(make("implicit", {{"field", from("solid")}, {"resolution", 8}}), {{"factors", 2}}) ==
        Codes{"degenerate wall.factors"});
}

TEST_CASE("A family of thicknesses makes a family of walls") {
  CatalogueGraph graph = graph_of({{"ball", coarse_ball},
                                   {"t", make("list", {{"items", {0.1, 0.2, 0.3}}})},
                                   {"walls", make("thicken", {{"shape", from("ball")}, {"thickness", from("t")}})}});
  const std::vector<SharedMesh> walls = graph.all<SharedMesh>("walls");
  REQUIRE(walls.size() == 3);
  CHECK(measure(*walls[2], never_stopped).volume > measure(*walls[0], never_stopped).volume);
}

TEST_CASE("Offset moves along normals and back, and far meshes refuse what their coordinates cannot tell") {
  CatalogueGraph graph =
      graph_of({{"ball", coarse_ball},
                {"grown", make("offset", {{"shape", from("ball")}, {"distance", 0.5}})},
                {"still", make("offset", {{"shape", from("ball")}, {"distance", 0}})},
                {"away", make("sphere_mesh", {{"center", {1e9, 0, 0}}, {"segments", 8}, {"rings", 4}})},
                {"wall", make("thicken", {{"shape", from("away")}, {"thickness", 1e-4}})}});
  const SharedMesh grown = graph.one<SharedMesh>("grown");
  for (std::size_t i = 0; i < grown->positions.size(); ++i) {
    CHECK(length(to_vector(grown->positions[i])) == Approx(1.5).epsilon(1e-14));
  }
  CHECK((*graph.one<SharedMesh>("still")->positions == *graph.one<SharedMesh>("ball")->positions));
  CHECK(codes(graph.problems("wall")) == std::multiset<std::string>{"out-of-range wall.thickness"});
}

TEST_CASE("Cap closes a pipe and counts its caps, and too many rings are refused") {
  const Json nodes = {{"height", make("range", {{"to", 2}, {"count", 5}})},
                      {"up", make("vector", {{"z", from("height")}})},
                      {"ring", make("circle")},
                      {"rings", make("translate", {{"shape", from("ring")}, {"vector", from("up")}})},
                      {"pipe", make("surface", {{"shape", from("rings")}, {"segments", 64}})},
                      {"flat", make("cap", {{"shape", from("pipe")}})},
                      {"domes", make("cap", {{"shape", from("pipe")}, {"kind", "dome"}})},
                      {"again", make("cap", {{"shape", from("domes")}})},
                      {"finest", make("cap", {{"shape", from("pipe")}, {"kind", "dome"}, {"rings", 256}})},
                      {"flat_measure", make("measure", {{"model", from("flat")}})},
                      {"dome_measure", make("measure", {{"model", from("domes")}})}};
  CatalogueGraph graph = graph_of(nodes);
  CHECK(graph.one<double>("flat.caps") == 2);
  CHECK(graph.one<double>("again.caps") == 0);
  CHECK(graph.one<double>("flat_measure.euler") == 2);
  CHECK(std::abs(graph.one<double>("flat_measure.volume")) == Approx(2 * 3.14159265).epsilon(3e-3));
  CHECK(std::abs(graph.one<double>("dome_measure.volume")) == Approx((2 + 4.0 / 3) * 3.14159265).epsilon(1e-2));
  CHECK(codes(graph.problems("finest")) == std::multiset<std::string>{"limit-exceeded finest.rings"});
}

TEST_CASE("A mesh that no wall and no cap fits is refused with its place") {
  const Json nodes = {{"sheet", make("grid", {{"count_u", 3}, {"count_v", 3}})},
                      {"skin", make("surface", {{"shape", from("sheet.points")}})},
                      {"twice", make("merge", {{"meshes", {from("skin"), from("skin")}}})},
                      {"wall", make("thicken", {{"shape", from("twice")}})},
                      {"lid", make("cap", {{"shape", from("twice")}})},
                      {"sound", make("printability", {{"model", from("twice")}, {"most_intersections", 5}})}};
  CatalogueGraph graph = graph_of(nodes);
  for (const char* node : {"wall", "lid"}) {
    const Problems problems = graph.problems(node);
    REQUIRE(codes(problems) == std::multiset<std::string>{"degenerate " + std::string(node) + ".shape"});
    CHECK(problems[0].detail.find("the edge from (") != std::string::npos);
  }
  CHECK(graph.one<double>("sound.self_intersections") == 5);
  CHECK(graph.one<double>("sound.watertight") == 0);
}

TEST_CASE("Printability tells holes, pieces, mass and where a check would fail") {
  CatalogueGraph graph =
      graph_of({{"box", make("box_mesh", {{"center", {1, 2, 3}}, {"size", {1, 2, 3}}, {"segments", 2}})},
                {"sound", make("printability", {{"model", from("box")}})},
                {"sheet", make("grid", {{"count_u", 3}, {"count_v", 3}})},
                {"skin", make("surface", {{"shape", from("sheet.points")}})},
                {"open", make("printability", {{"model", from("skin")}})},
                {"must", make("check", {{"value", from("open.watertight")}, {"minimum", 1}})}});
  CHECK(graph.one<double>("sound.watertight") == 1);
  CHECK(graph.one<double>("sound.least_thickness") == Approx(1));
  const Point center = graph.one<Point>("sound.center_of_mass");
  CHECK(length(to_vector(center) - Vector{1, 2, 3}) < 1e-12);
  CHECK(graph.one<Vector>("sound.inertia").x == Approx(6 * (4 + 9) / 12.0));
  CHECK(graph.one<double>("open.watertight") == 0);
  CHECK(graph.one<double>("open.boundary_loops") == 1);
  CHECK(graph.one<double>("open.least_thickness") == 0);
  CHECK(codes(graph.problems("must")) == std::multiset<std::string>{"check-failed must.value"});
}

TEST_CASE("The objects of the gallery are solids for random settings within their bounds") {
  for (const Promise& promise :
       {Promise{"object_vase", "vase", 2}, Promise{"object_ring", "ring", 0}, Promise{"object_pavilion", "roof", 2}}) {
    const Json document = read_object(promise.id);
    RandomElements random(15);
    for (int round = 0; round < 3; ++round) {
      const Json values = setting(document, round, random);
      CAPTURE(promise.id, values.dump());
      CatalogueGraph graph = graph_of(with_values(document["nodes"], values));
      const SharedMesh mesh = graph.one<SharedMesh>(promise.mesh);
      require_solid(promise, mesh);
      // A wall that meets itself would have warned.
      for (const Warning& warning : graph.warnings()) FAIL_CHECK(warning.code << ": " << warning.detail);
      if (promise.euler == 0) CHECK(contacts_of(welded(*mesh, never_stopped), 10, never_stopped).pairs == 0);
    }
  }
}

TEST_CASE("The pendant of the gallery is one solid for random settings within its bounds") {
  const Json document = read_object("object_pendant");
  RandomElements random(16);
  for (int round = 0; round < 3; ++round) {
    const Json values = setting(document, round, random);
    CAPTURE(values.dump());
    Json nodes = with_values(document["nodes"], values);
    nodes["pendant"]["inputs"]["resolution"] = 96;
    CatalogueGraph graph = graph_of(nodes);
    const SharedMesh pendant = graph.one<SharedMesh>("pendant");
    require_solid({"object_pendant", "pendant", {}}, pendant);
    CHECK(graph.warnings().empty());
    CHECK(soundness_of(welded(*pendant, never_stopped), never_stopped).components == 1);
  }
}
