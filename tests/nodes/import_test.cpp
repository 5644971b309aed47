#include "tests/support/catalogue.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("an imported mesh keeps its texture coordinates and colors through a warp") {
  CatalogueGraph graph =
      graph_of({{"file", make("import", {{"asset", "square"}})},
                {"pair", make("point_pair", {{"position", {0.5, 0.5, 1}}, {"direction", {0, 0, 1}}})},
                {"fine", make("subdivide", {{"shape", from("file")}, {"levels", 3}})},
                {"bent", make("warp", {{"shape", from("fine")}, {"generators", {from("pair")}}})}});
  const SharedMesh flat = graph.one<SharedMesh>("fine"), bent = graph.one<SharedMesh>("bent");
  REQUIRE(flat->uvs.size() == flat->positions.size());
  REQUIRE(flat->colors.size() == flat->positions.size());
  CHECK(bent->uvs == flat->uvs);
  CHECK(bent->colors == flat->colors);
  CHECK_FALSE(bent->positions == flat->positions);
  CHECK(graph.one<SharedMesh>("file")->colors[1] == std::array<float, 4>{0, 1, 0, 1});
}

TEST_CASE("an import turns, scales and centers what the file holds") {
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

TEST_CASE("a file that is not known is a problem of the node that names it") {
  const CatalogueGraph graph = graph_of({{"file", make("import", {{"asset", "nobody"}})}});
  CHECK(codes(graph.static_problems()) == std::multiset<std::string>{"unknown-asset file.asset"});
  CHECK(graph.static_problems().front().pointer == "/graph/nodes/file/inputs/asset");
  CHECK(codes(graph_of({{"file", make("import")}}).static_problems()) ==
        std::multiset<std::string>{"required-input-missing file.asset"});
}

TEST_CASE("the size of an imported mesh is known before anything is computed") {
  const CatalogueGraph graph = graph_of({{"file", make("import", {{"asset", "square"}})}});
  CHECK(graph.planned("file").outputs.front().vertices == 4);
}
