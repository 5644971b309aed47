#include "geometry/text_reader.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace dini;

TEST_CASE("Numbers are read as programs of every kind print them") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [word, value] :
       std::vector<std::pair<std::string, double>>{{"0", 0},
                                                   {"-1.5", -1.5},
                                                   {"+2", 2},
                                                   {".5", 0.5},
                                                   {"5.", 5},
                                                   {"1e5", 1e5},
                                                   {"1E+05", 1e5},
                                                   {"inf", infinity},
                                                   {"-Infinity", -infinity},
                                                   {"INF", infinity},
                                                   {"1e400", infinity},
                                                   {"-1e400", -infinity},
                                                   {"1.#INF", infinity},
                                                   {"-1.#INF00", -infinity},
                                                   {"1e-400", 0},
                                                   {"-1e-400", 0},
                                                   {"4e-324", 5e-324},
                                                   {"1e-99999999999999999999", 0},
                                                   {"1e99999999999999999999", infinity},
                                                   {"0." + std::string(500, '0') + "1", 0},
                                                   {"1" + std::string(500, '0'), infinity},
                                                   {"1" + std::string(500, '0') + "e-500", 1}}) {
    CAPTURE(word);
    CHECK(real_from(word) == std::optional(value));
  }
  for (const std::string word :
       {"nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "nan(snan)", "1.#QNAN", "-1.#IND", "1.#IND00", "1.#SNAN"}) {
    CAPTURE(word);
    REQUIRE(real_from(word));
    CHECK(std::isnan(*real_from(word)));
  }
  for (const std::string word :
       {"", "x", "0x10", "1e", "--1", "+-1", "1.5.5", ".", "-", "1,5", "1 ", "1.#", "1.#J", "nano"}) {
    CAPTURE(word);
    CHECK_FALSE(real_from(word));
  }
}

TEST_CASE("A whole number may be written with a fraction of zeros, and with nothing else") {
  CHECK(whole_from("255.0") == 255);
  CHECK(whole_from("-3.") == -3);
  CHECK(whole_from("1e3") == 1000);
  CHECK(whole_from("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
  for (const std::string word : {"0.5", "nan", "inf", "1e300", "", "x", "99999999999999999999"}) {
    CAPTURE(word);
    CHECK_FALSE(whole_from(word));
  }
}

TEST_CASE("A word of a file is quoted without what could break a message") {
  CHECK(in_quotes("a b") == "\"a b\"");
  CHECK(in_quotes("\x1b[2J\xff") == "\"?[2J?\"");
  CHECK(in_quotes(std::string(1000, 'x')) == '"' + std::string(32, 'x') + "...\"");
}
