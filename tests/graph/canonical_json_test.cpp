#include "graph/canonical_json.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>

using namespace dini;

namespace {

double of_bits(std::uint64_t bits) { return std::bit_cast<double>(bits); }

std::string number(double value) { return canonical_json(Json(value)); }

}  // namespace

TEST_CASE("Numbers have the text that RFC 8785 gives for their bits") {
  CHECK(number(0.0) == "0");
  CHECK(number(-0.0) == "0");
  CHECK(number(of_bits(0x0000000000000001)) == "5e-324");
  CHECK(number(of_bits(0x8000000000000001)) == "-5e-324");
  CHECK(number(of_bits(0x7fefffffffffffff)) == "1.7976931348623157e+308");
  CHECK(number(of_bits(0x4340000000000000)) == "9007199254740992");
  CHECK(number(of_bits(0xc340000000000000)) == "-9007199254740992");
  CHECK(number(of_bits(0x4430000000000000)) == "295147905179352830000");
  CHECK(number(of_bits(0x44b52d02c7e14af5)) == "9.999999999999997e+22");
  CHECK(number(of_bits(0x44b52d02c7e14af6)) == "1e+23");
  CHECK(number(of_bits(0x44b52d02c7e14af7)) == "1.0000000000000001e+23");
  CHECK(number(of_bits(0x444b1ae4d6e2ef4e)) == "999999999999999700000");
  CHECK(number(of_bits(0x444b1ae4d6e2ef50)) == "1e+21");
  CHECK(number(of_bits(0x3eb0c6f7a0b5ed8c)) == "9.999999999999997e-7");
  CHECK(number(of_bits(0x3eb0c6f7a0b5ed8d)) == "0.000001");
  CHECK(number(of_bits(0x41b3de4355555553)) == "333333333.3333332");
  CHECK(number(of_bits(0x41b3de4355555557)) == "333333333.33333343");
  CHECK(number(of_bits(0xbecbf647612f3696)) == "-0.0000033333333333333333");
  CHECK(number(of_bits(0x43143ff3c1cb0959)) == "1424953923781206.2");
}

TEST_CASE("A number as text reads back as itself") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 10'000; ++i) {
    const double value = of_bits(random());
    if (!std::isfinite(value)) continue;
    CHECK(std::strtod(number(value).c_str(), nullptr) == value);
  }
}

TEST_CASE("Texts and names are written as RFC 8785 shows") {
  const Json sample = Json::parse(
      "{\"numbers\": [333333333.33333329, 1E30, 4.50, 2e-3, 0.000000000000000000000000001],"
      "\"string\": \"\\u20ac$\\u000F\\u000aA'\\u0042\\u0022\\u005c\\\\\\\"\\/\",\"literals\": [null, true, false]}");
  CHECK(canonical_json(sample) ==
        "{\"literals\":[null,true,false],\"numbers\":[333333333.3333333,1e+30,4.5,0.002,1e-27],"
        "\"string\":\"\u20ac$\\u000f\\nA'B\\\"\\\\\\\\\\\"/\"}");
}

TEST_CASE("Names stand in the order of their UTF-16 code units") {
  // A smiling face is beyond the first 65,536 characters, a Hebrew letter with a point is among the last of those.
  const Json names = {{"\u20ac", 1},     {"\r", 2},     {"\ufb33", 3}, {"1", 4},
                      {"\U0001F600", 5}, {"\u0080", 6}, {"\u00f6", 7}};
  CHECK(canonical_json(names) ==
        "{\"\\r\":2,\"1\":4,\"\u0080\":6,\"\u00f6\":7,\"\u20ac\":1,\"\U0001F600\":5,\"\ufb33\":3}");
}

TEST_CASE("Only members of the outermost object are left out") {
  const Json json = {{"ui", 1}, {"a", {{"ui", 2}}}};
  constexpr std::array<std::string_view, 1> left_out = {"ui"};
  CHECK(canonical_json(json, left_out) == R"({"a":{"ui":2}})");
}
