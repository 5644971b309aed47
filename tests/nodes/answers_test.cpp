// merge, color, measure, check and export.

#include <catch2/catch.hpp>

#include "gltf/glb_container.h"
#include "gltf/glb_reader.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json unit_ball = make("sphere_mesh", {{"segments", 128}, {"rings", 64}});
const Json torus = make("torus_mesh", {{"center", {3, 0, 0}}});

std::size_t triangles_of(const Scene& scene) {
  std::size_t count = 0;
  for (const Part& part : scene.parts) {
    if (const auto* mesh = std::get_if<SharedMesh>(&part.shape)) count += (*mesh)->triangles.size();
  }
  return count;
}

}  // namespace

TEST_CASE("Measure knows spheres and tori") {
  CatalogueGraph graph = graph_of({{"ball", unit_ball},
                                   {"ring", torus},
                                   {"b", make("measure", {{"model", from("ball")}})},
                                   {"r", make("measure", {{"model", from("ring")}})}});
  CHECK(graph.one<double>("b.area") == Approx(4 * 3.14159265).epsilon(0.002));
  CHECK(graph.one<double>("b.volume") == Approx(4.0 / 3 * 3.14159265).epsilon(0.003));
  CHECK(graph.one<double>("b.euler") == 2);
  CHECK(graph.one<double>("b.diagonal") == Approx(std::sqrt(12.0)).epsilon(1e-3));
  require_close(graph.one<Point>("b.maximum"), Point{1, 1, 1}, 1e-12);
  CHECK(graph.one<double>("r.euler") == 0);
  CHECK(graph.one<double>("r.volume") == Approx(2 * 9.8696 * 0.09).epsilon(0.005));
  CHECK(graph.one<Point>("r.minimum").x == Approx(1.7));
  const auto mesh = graph.one<SharedMesh>("ring");
  CHECK(graph.one<double>("r.triangles") == static_cast<double>(mesh->triangles.size()));
}

TEST_CASE("Merge joins all links and all values of their axes") {
  CatalogueGraph graph = graph_of({{"ball", unit_ball},
                                   {"ring", torus},
                                   {"k", make("range", {{"from", 10}, {"to", 20}, {"count", 3}})},
                                   {"aside", make("vector", {{"y", from("k")}})},
                                   {"row", make("translate", {{"shape", from("ball")}, {"vector", from("aside")}})},
                                   {"all", make("merge", {{"meshes", {from("ring"), from("row")}}})},
                                   {"m", make("measure", {{"model", from("all")}})}});
  CHECK(graph.json("all")["axes"].empty());
  CHECK(graph.one<double>("m.euler") == 6);
  const auto one = graph.one<SharedMesh>("ball"), other = graph.one<SharedMesh>("ring"),
             all = graph.one<SharedMesh>("all");
  CHECK(all->triangles.size() == 3 * one->triangles.size() + other->triangles.size());
}

TEST_CASE("Color paints a mesh and leaves its shape alone") {
  CatalogueGraph graph =
      graph_of({{"ball", unit_ball}, {"red", make("color", {{"shape", from("ball")}, {"color", {1, 0.25, 0}}})}});
  const auto before = graph.one<SharedMesh>("ball"), after = graph.one<SharedMesh>("red");
  CHECK(after->color == Color{1, 0.25, 0, 1});
  CHECK((after->positions == before->positions));
  CHECK(after->triangles.data() == before->triangles.data());
}

TEST_CASE("A material reaches the file, and colors that follow leave its finish alone") {
  const Json look = {{"shape", from("ball")}, {"color", {1, 0.25, 0}}, {"opacity", 0.5},
                     {"metallic", 1},         {"roughness", 0.2},      {"double_sided", false}};
  CatalogueGraph graph = graph_of({{"ball", unit_ball},
                                   {"glass", make("material", look)},
                                   {"shaded", make("curvature_color", {{"shape", from("glass")}})},
                                   {"moved", make("translate", {{"shape", from("shaded")}, {"vector", {9, 0, 0}}})},
                                   {"out", make("export", {{"model", {from("glass"), from("ball"), from("moved")}}})}});
  const auto glass = graph.one<SharedMesh>("glass"), moved = graph.one<SharedMesh>("moved");
  CHECK(glass->color == Color{1, 0.25, 0, 0.5});
  CHECK((glass->positions == graph.one<SharedMesh>("ball")->positions));
  CHECK_FALSE(moved->colors.empty());
  CHECK(moved->finish == Finish{1, 0.2, false});
  const auto chunks = split_glb(*graph.one<SharedFile>("out")->bytes);
  REQUIRE(chunks);
  const Json materials = Json::parse(chunks->json)["materials"];
  REQUIRE(materials.size() == 3);
  CHECK(materials[0] ==
        Json{{"name", "glass"},
             {"alphaMode", "BLEND"},
             {"doubleSided", false},
             {"pbrMetallicRoughness",
              {{"baseColorFactor", {1.0, 0.25, 0.0, 0.5}}, {"metallicFactor", 1.0}, {"roughnessFactor", 0.2}}}});
  CHECK(materials[1]["doubleSided"] == true);
  CHECK(materials[1]["pbrMetallicRoughness"]["roughnessFactor"] == 0.6);
  CHECK(materials[2]["pbrMetallicRoughness"]["metallicFactor"] == 1.0);
}

TEST_CASE("Check passes a number on within its bounds and fails beyond, with its message") {
  const auto checked_number = [](double value) {
    return graph_of(
        {{"c", make("check", {{"value", value}, {"minimum", 1}, {"maximum", 2}, {"message", "too thick"}})}});
  };
  for (const double value : {1.0, 1.5, 2.0}) CHECK(checked_number(value).one<double>("c") == value);
  for (const double value : {0.999, 2.001}) {
    const Problems problems = checked_number(value).problems("c");
    REQUIRE(codes(problems) == std::multiset<std::string>{"check-failed c.value"});
    CHECK(problems[0].detail.starts_with("too thick: got "));
    CHECK(problems[0].detail.ends_with("accepted is 1 to 2"));
  }
  CHECK(graph_of({{"c", make("check", {{"value", -1e300}})}}).one<double>("c") == -1e300);
}

TEST_CASE("An exported file holds what was exported, within the announced bound") {
  CatalogueGraph graph = graph_of({{"ball", unit_ball},
                                   {"red", make("color", {{"shape", from("ball")}, {"color", {1, 0, 0}}})},
                                   {"circle", make("circle", {{"radius", 2}})},
                                   {"dots", make("sample", {{"shape", from("circle")}, {"count", 5}})},
                                   {"out", make("export", {{"model", {from("red"), from("circle"), from("dots")}}})}});
  const auto asset = graph.one<SharedFile>("out");
  CHECK(asset->media_type == "model/gltf-binary");
  const std::optional<Scene> scene = read_glb(*asset->bytes);
  REQUIRE(scene);
  REQUIRE(scene->parts.size() == 3);
  const auto before = graph.one<SharedMesh>("ball");
  const SharedMesh mesh = std::get<SharedMesh>(scene->parts[0].shape);
  CHECK(mesh->color == Color{1, 0, 0, 1});
  CHECK(mesh->triangles.size() == before->triangles.size());
  CHECK(asset->triangles == before->triangles.size());
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
    CHECK(std::abs(length(to_vector(mesh->positions[i])) - 1) <= 2 * asset->position_error + 1e-12);
  }
  const Column<Point>& dots = *std::get<SharedColumn<Point>>(scene->parts[2].shape);
  REQUIRE(dots.size() == 5);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    CHECK(distance(dots[i], graph.all<Point>("dots")[i]) <= 1e-6);
  }
}

TEST_CASE("What an export leaves out is a warning, and nothing at all is an error that says why") {
  const Json nodes = {{"far", make("list", {{"items", {{0, 0, 0}, {1e300, 0, 0}, {0, 2e18, 0}}}})},
                      {"spots", make("translate", {{"shape", from("far")}})},
                      {"lost", make("point", {{"position", {0, 0, 1e19}}})},
                      {"ball", make("sphere_mesh", {{"center", {0, 1e17, 0}}, {"segments", 6}, {"rings", 4}})},
                      {"out", make("export", {{"model", from("spots")}})},
                      {"none", make("export", {{"model", {from("lost"), from("ball")}}})}};
  CatalogueGraph graph = graph_of(nodes);
  graph.one<SharedFile>("out");
  REQUIRE(graph.warnings().size() == 1);
  CHECK(graph.warnings()[0].code == "at-infinity");
  CHECK(graph.warnings()[0].detail.starts_with("2 of 3 points of spots "));
  const Problems problems = graph.problems("none");
  CHECK(codes(problems) == std::multiset<std::string>{"nothing-to-export none.model"});
  CHECK(problems.front().detail.find("lost (Point), has nothing nearer") != std::string::npos);
  CHECK(problems.front().detail.find("ball (Sphere mesh), has no triangles") != std::string::npos);
}

TEST_CASE("A draft is coarser and a final answer is not bounded") {
  const Json nodes = {{"k", make("range", {{"to", 6.25}, {"count", 300}})},
                      {"aside", make("vector", {{"z", from("k")}})},
                      {"ring", make("circle")},
                      {"rings", make("translate", {{"shape", from("ring")}, {"vector", from("aside")}})},
                      {"skin", make("surface", {{"shape", from("rings")}, {"segments", 200}})},
                      {"out", make("export", {{"model", from("skin")}})}};
  CatalogueGraph usual = graph_of(nodes), draft = graph_of(nodes, Quality::draft);
  const auto final_scene = read_glb(*usual.one<SharedFile>("out")->bytes),
             draft_scene = read_glb(*draft.one<SharedFile>("out")->bytes);
  REQUIRE((final_scene && draft_scene));
  CHECK(triangles_of(*final_scene) == 2 * 299 * 200);
  CHECK(triangles_of(*draft_scene) <= 20'000);
  CHECK(triangles_of(*draft_scene) > 5'000);
  CHECK(usual.planned("skin").fingerprint != draft.planned("skin").fingerprint);
  CHECK(usual.planned("rings").fingerprint == draft.planned("rings").fingerprint);
}
