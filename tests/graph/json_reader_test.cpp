#include "graph/json_reader.h"

#include <catch2/catch.hpp>

using namespace dini;

namespace {

Json parsed(const std::string& text) {
  const Result<Json> json = parse_json(text, {});
  REQUIRE(json);
  return *json;
}

}  // namespace

TEST_CASE("A number is the same however it is spelled") {
  for (const auto* text : {"16", "16.0", "1.6e1", "160e-1", "16.000", "0.16E+2"}) {
    CAPTURE(text);
    CHECK(parsed(text).is_number_integer());
    CHECK(parsed(text).dump() == "16");
  }
  for (const auto* text : {"0", "-0", "0.0", "-0.0", "0e5", "-0e-5", "1e-400"}) {
    CAPTURE(text);
    CHECK(parsed(text).dump() == "0");
  }
  CHECK(parsed("-2.0").dump() == "-2");
  CHECK(parsed("2.50").dump() == "2.5");
  CHECK(parsed("9007199254740993").dump() == parsed("9007199254740993.0").dump());
  CHECK(parsed("123456789012345678901234567890").is_number_float());
  CHECK(parsed("-123456789012345678901234567890").is_number_float());
}

TEST_CASE("What is no JSON is named by its line and column") {
  const auto said = [](const std::string& text) { return parse_json(text, {}).problems().front().detail; };
  CHECK(said("{\"a\": 1,\n  \"b\": x}") == "the text is not JSON, at line 2, column 8");
  CHECK(said("[1, 1e999]") == "a number is too large, at line 1, column 9");
  CHECK(said("{\"\xC3\xA9\": ?}") == "the text is not JSON, at line 1, column 7");
  CHECK(said("\xEF\xBB\xBF[}") == "the text is not JSON, at line 1, column 2");
  CHECK(said("") == "the text is not JSON, at line 1, column 1");
}

TEST_CASE("A byte order mark is passed over, once and at the beginning only") {
  const std::string mark = "\xEF\xBB\xBF";
  CHECK(parsed(mark + R"({"a": 1})")["a"] == 1);
  CHECK_FALSE(parse_json(mark + mark + "{}", {}));
  CHECK_FALSE(parse_json("{" + mark + "}", {}));
  CHECK_FALSE(parse_json(mark, {}));
}
