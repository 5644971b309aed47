#include <catch2/catch.hpp>

#include "gltf/glb_reader.h"
#include "gltf/glb_writer.h"
#include "tests/gltf/shapes.h"

namespace dini {
namespace {

TEST_CASE("a torus is written and read back") {
  const auto result = encode_scene(shapes::scene_of(shapes::torus(64, 32)), {}, Cancel());
  REQUIRE(std::holds_alternative<EncodedScene>(result));
  const auto& encoded = std::get<EncodedScene>(result);
  CHECK(encoded.vertices == 64 * 32);
  CHECK(encoded.triangles == 2 * 64 * 32);
  const auto scene = read_glb(encoded.glb);
  REQUIRE(scene);
  REQUIRE(scene->parts.size() == 1);
  CHECK(scene->parts[0].name == "mesh");
}

}  // namespace
}  // namespace dini
