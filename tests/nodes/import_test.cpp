#include "gltf/glb_reader.h"
#include "tests/support/catalogue.h"
#include "tests/support/picture_value.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("An imported mesh keeps its texture coordinates and colors through a warp") {
  CatalogueGraph graph =
      graph_of({{"file", make("import", {{"asset", "square"}})},
                {"pair", make("point_pair", {{"position", {0.5, 0.5, 1}}, {"direction", {0, 0, 0.3}}})},
                {"fine", make("subdivide", {{"shape", from("file")}, {"levels", 3}})},
                {"bent", make("warp", {{"shape", from("fine")}, {"generators", {from("pair")}}})}});
  const SharedMesh flat = graph.one<SharedMesh>("fine"), bent = graph.one<SharedMesh>("bent");
  REQUIRE(flat->uvs.size() == flat->positions.size());
  REQUIRE(flat->colors.size() == flat->positions.size());
  CHECK(bent->uvs == flat->uvs);
  CHECK(bent->colors == flat->colors);
  CHECK_FALSE((bent->positions == flat->positions));
  CHECK(graph.one<SharedMesh>("file")->colors[1] == std::array<float, 4>{0, 1, 0, 1});
}

TEST_CASE("An import turns, scales and centers what the file holds") {
  CatalogueGraph graph =
      graph_of({{"plain", make("import", {{"asset", "triangle"}})},
                {"upright", make("import", {{"asset", "triangle"}, {"up", "y"}})},
                {"placed", make("import", {{"asset", "triangle"}, {"scale", 10}, {"center", true}})}});
  CHECK(graph.one<SharedMesh>("plain")->positions[2] == Point{0, 1, 0.5});
  CHECK(graph.one<SharedMesh>("upright")->positions[2] == Point{0, -0.5, 1});
  CHECK(graph.one<SharedMesh>("placed")->positions[0] == Point{-5, -5, -2.5});
  const Vector up = graph.one<SharedMesh>("upright")->normals[0], plain = graph.one<SharedMesh>("plain")->normals[0];
  CHECK(length(up - Vector{plain.x, -plain.z, plain.y}) < 1e-15);
}

TEST_CASE("What of a file is not in its mesh is a warning of the node") {
  CatalogueGraph graph = graph_of({{"file", make("import", {{"asset", "short"}})}});
  CHECK(graph.one<SharedMesh>("file")->triangles.size() == 1);
  CHECK(graph.warnings() ==
        std::vector<Warning>{
            {"left-out", "1 face has fewer than three corners and is left out, the first at line 5", "asset"},
            {"left-out", "1 line (l) is left out", "asset"}});
}

TEST_CASE("The colors of a file come out of an export as they were") {
  CatalogueGraph graph =
      graph_of({{"file", make("import", {{"asset", "gray"}})}, {"out", make("export", {{"model", from("file")}})}});
  const auto scene = read_glb(*graph.one<SharedFile>("out")->bytes);
  REQUIRE(scene);
  const Mesh& mesh = *std::get<SharedMesh>(scene->parts.at(0).shape);
  REQUIRE(mesh.colors.size() == 256);
  for (std::size_t i = 0; i < 256; ++i) {
    // The vertex with the gray value g stands at x = g.
    CHECK(picture_value(static_cast<double>(mesh.colors[i][1])) == std::lround(mesh.positions[i].x));
  }
}

TEST_CASE("An export tells when texture coordinates lose much by rounding") {
  CatalogueGraph graph = graph_of({{"file", make("import", {{"asset", "far"}})},
                                   {"near", make("import", {{"asset", "square"}})},
                                   {"out", make("export", {{"model", {from("near"), from("file")}}})},
                                   {"quiet", make("export", {{"model", from("near")}})}});
  graph.value("out");
  REQUIRE(graph.warnings().size() == 1);
  CHECK(
      graph.warnings()[0] ==
      Warning{"imprecise",
              "the texture coordinates of file reach from 0 to 100001 and are rounded by up to 12, where 1 is the size "
              "of the picture",
              "model"});
  graph.value("quiet");
  CHECK(graph.warnings().empty());
}

TEST_CASE("A file that is not known is a problem of the node that names it") {
  const CatalogueGraph graph = graph_of({{"file", make("import", {{"asset", "nobody"}})}});
  CHECK(codes(graph.static_problems()) == std::multiset<std::string>{"unknown-asset file.asset"});
  CHECK(graph.static_problems().front().pointer == "/nodes/file/inputs/asset");
  CHECK(codes(graph_of({{"file", make("import")}}).static_problems()) ==
        std::multiset<std::string>{"required-input-missing file.asset"});
}

TEST_CASE("The size of an imported mesh is known before anything is computed") {
  const CatalogueGraph graph = graph_of({{"file", make("import", {{"asset", "square"}})}});
  CHECK(graph.planned("file").outputs.front().vertices == 4);
}
