#include "queue/sealed.h"

#include <catch2/catch.hpp>

using namespace dini;

TEST_CASE("What was sealed comes out as it went in") {
  for (const std::string& bytes : {std::string(), std::string("a\nb\0c", 5), std::string(100'000, 'x')}) {
    const std::string value = queue::sealed("model/gltf-binary", "1.2.3", bytes);
    const auto opened = queue::unsealed(value, "model/gltf-binary", "1.2.3");
    REQUIRE(opened);
    CHECK(*opened == bytes);
  }
}

TEST_CASE("Damage anywhere, another type and another engine are seen") {
  const std::string value = queue::sealed("model/gltf-binary", "1.2.3", "some bytes");
  for (std::size_t place = 0; place < value.size(); ++place) {
    std::string flipped = value;
    flipped[place] = static_cast<char>(flipped[place] ^ 1);
    CAPTURE(place);
    CHECK_FALSE(queue::unsealed(flipped, "model/gltf-binary", "1.2.3"));
    CHECK_FALSE(queue::unsealed(value.substr(0, place), "model/gltf-binary", "1.2.3"));
  }
  CHECK_FALSE(queue::unsealed(value + "x", "model/gltf-binary", "1.2.3"));
  CHECK_FALSE(queue::unsealed(value, "model/obj", "1.2.3"));
  CHECK_FALSE(queue::unsealed(value, "model/gltf-binary", "1.2.4"));
}
