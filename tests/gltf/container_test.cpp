#include <catch2/catch.hpp>

#include "geometry/json.h"
#include "gltf/base64.h"
#include "gltf/glb_container.h"
#include "gltf/glb_reader.h"
#include "tests/gltf/compare.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

std::string torus(EncodeOptions options = {}) {
  return compare::encode(shapes::scene_of(shapes::torus(20, 10)), options).file;
}

/// The bytes that base64 means; nothing for a text that is none.
std::optional<std::string> from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count & 0xFF));
  }
  return bytes;
}

}  // namespace

TEST_CASE("What a file says about itself changes nothing else of it") {
  const std::string plain = torus();
  for (std::size_t length = 0; length < 8; ++length) {
    const Json extras = {{"hash", std::string(length, 'a')}, {"engine", "0.1.0"}, {"parameters", {{"width", 0.1}}}};
    const std::string glb = torus({.extras = extras});
    CHECK(glb.size() % 4 == 0);
    const auto chunks = split_glb(glb);
    REQUIRE(chunks);
    CHECK(chunks->json.size() % 4 == 0);
    CHECK(chunks->binary == split_glb(plain)->binary);
    Json document = Json::parse(chunks->json);
    CHECK(document["asset"]["extras"] == extras);
    document["asset"].erase("extras");
    CHECK(document == Json::parse(split_glb(plain)->json));
    CHECK(read_glb(glb));
  }
}

TEST_CASE("Extras with text that is not UTF-8 are written with replacement characters") {
  const std::string glb = torus({.extras = {{"name", "\xff"}}});
  const auto chunks = split_glb(glb);
  REQUIRE(chunks);
  CHECK(Json::parse(chunks->json)["asset"]["extras"]["name"] == "\xEF\xBF\xBD");
}

TEST_CASE("GlTF with its data inside holds what the GLB holds") {
  const std::string glb = torus();
  Json embedded = Json::parse(torus({.container = GltfContainer::embedded}));
  const std::string uri = embedded["buffers"][0]["uri"];
  const std::string_view start = "data:application/octet-stream;base64,";
  REQUIRE(uri.starts_with(start));
  const auto chunks = split_glb(glb);
  REQUIRE(chunks);
  CHECK(from_base64(std::string_view(uri).substr(start.size())) == std::string(chunks->binary));
  embedded["buffers"][0].erase("uri");
  CHECK(embedded == Json::parse(chunks->json));
}

TEST_CASE("Base64 is that of its standard, whatever the length") {
  CHECK(to_base64("") == "");
  CHECK(to_base64("f") == "Zg==");
  CHECK(to_base64("fo") == "Zm8=");
  CHECK(to_base64("foo") == "Zm9v");
  CHECK(to_base64("foobar") == "Zm9vYmFy");
  for (const std::size_t size : {std::size_t{3} << 20, (std::size_t{3} << 20) + 1, std::size_t{7} << 20}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 2654435761U >> 13);
    CHECK(from_base64(to_base64(bytes)) == bytes);
  }
}

TEST_CASE("What is no file of ours is not read") {
  const std::string glb = torus();
  for (std::size_t size = 0; size < glb.size(); size += 7) {
    CHECK_FALSE(split_glb(glb.substr(0, size)));
    CHECK_FALSE(read_glb(glb.substr(0, size)));
  }
  CHECK_FALSE(split_glb(std::string(100, 'x')));
}
