#include <catch2/catch.hpp>

#include "geometry/json.h"
#include "gltf/glb_container.h"
#include "gltf/glb_reader.h"
#include "tests/gltf/compare.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

TEST_CASE("Stamping extras keeps the binary chunk and everything else") {
  const std::string glb = compare::encode(shapes::scene_of(shapes::torus(20, 10))).glb;
  for (std::size_t length = 0; length < 8; ++length) {
    const Json extras = {{"hash", std::string(length, 'a')}, {"engine", "0.1.0"}, {"parameters", {{"width", 0.1}}}};
    const std::string stamped = stamp_extras(glb, extras);
    CHECK(stamped.size() % 4 == 0);
    const auto chunks = split_glb(stamped);
    REQUIRE(chunks);
    CHECK(chunks->json.size() % 4 == 0);
    CHECK(chunks->binary == split_glb(glb)->binary);
    Json document = Json::parse(chunks->json);
    CHECK(document["asset"]["extras"] == extras);
    document["asset"].erase("extras");
    CHECK(document == Json::parse(split_glb(glb)->json));
    CHECK(stamp_extras(glb, extras) == stamped);
    CHECK(stamp_extras(stamp_extras(glb, {{"old", 1}}), extras) == stamped);
    CHECK(read_glb(stamped));
  }
}

TEST_CASE("Extras with text that is not UTF-8 are written with replacement characters") {
  const std::string glb = compare::encode(shapes::scene_of(shapes::torus(20, 10))).glb;
  CHECK(split_glb(stamp_extras(glb, {{"name", "\xff"}})));
}

TEST_CASE("What is no file of ours is neither stamped nor read") {
  const std::string glb = compare::encode(shapes::scene_of(shapes::torus(20, 10))).glb;
  for (std::size_t size = 0; size < glb.size(); size += 7) {
    CHECK_FALSE(split_glb(glb.substr(0, size)));
    CHECK(stamp_extras(glb.substr(0, size), {}).empty());
    CHECK_FALSE(read_glb(glb.substr(0, size)));
  }
  CHECK_FALSE(split_glb(std::string(100, 'x')));
}

}  // namespace
