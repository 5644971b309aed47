#include <array>
#include <catch2/catch.hpp>

#include "server/negotiation.h"
#include "server/page.h"
#include "server/text.h"
#include "service/requests/excerpt.h"

using namespace dini;
using server::carries_hash;
using server::choose_type;
using server::escape_controls;
using server::names_tag;

namespace {

constexpr std::array<std::string_view, 3> offers = {"model/gltf-binary", "application/json", "multipart/form-data"};

std::string_view chosen(std::string_view accept) { return choose_type(accept, offers).value_or("none"); }

}  // namespace

TEST_CASE("Accept headers choose the best offer") {
  CHECK(chosen("") == "model/gltf-binary");
  CHECK(chosen("*/*") == "model/gltf-binary");
  CHECK(chosen("application/json") == "application/json");
  CHECK(chosen("application/*, model/*;q=0.5") == "application/json");
  CHECK(chosen("application/json;q=0.5, multipart/form-data") == "multipart/form-data");
  CHECK(chosen("*/*;q=0.1, model/gltf-binary;q=0") == "application/json");
  CHECK(chosen("Application/JSON; charset=utf-8; q=1") == "application/json");
  CHECK(chosen("text/html") == "none");
  CHECK(chosen("*/*;q=nonsense") == "none");
  CHECK(chosen(",;,") == "none");
}

TEST_CASE("Tags are compared as a whole") {
  CHECK(names_tag("\"a\"", "\"a\""));
  CHECK(names_tag("\"b\" , W/\"a\"", "\"a\""));
  CHECK(names_tag("*", "\"a\""));
  CHECK_FALSE(names_tag("", "\"a\""));
  CHECK_FALSE(names_tag("a", "\"a\""));
  CHECK_FALSE(names_tag("\"aa\"", "\"a\""));
}

TEST_CASE("Hashed names are told from plain ones") {
  CHECK(carries_hash("/assets/main-5ZQ2W7KD.js"));
  CHECK(carries_hash("/main-5ZQ2W7KD.js.map"));
  CHECK_FALSE(carries_hash("/index.html"));
  CHECK_FALSE(carries_hash("/my-component.js"));
  CHECK_FALSE(carries_hash("/-.js"));
}

TEST_CASE("Text from outside is made harmless") {
  CHECK(escape_controls("a\x1b[2J\n\xc3\xa9") == "a\\x1b[2J\\x0a\\xc3\\xa9");
  CHECK(escape_controls(std::string(300, 'a')).size() == 203);
  CHECK(text_excerpt("a\xc3\xa9", 2) == "a");
  CHECK(text_excerpt("a\xc3\xa9", 3) == "a\xc3\xa9");
}
