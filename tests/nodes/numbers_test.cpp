#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/catalogue.h"

using namespace dini;
using namespace dini::support;

namespace {

std::vector<double> range(double first, double last, int count, bool closed) {
  CatalogueGraph graph =
      graph_of({{"r", make("range", {{"from", first}, {"to", last}, {"count", count}, {"closed", closed}})}});
  return graph.all<double>("r");
}

CatalogueGraph formula(const std::string& text, double x = 0, double y = 0, double z = 0, double w = 0) {
  return graph_of({{"f", make("expression", {{"formula", text}, {"x", x}, {"y", y}, {"z", z}, {"w", w}})}});
}

double formula_value(const std::string& text, double x = 0, double y = 0, double z = 0, double w = 0) {
  return formula(text, x, y, z, w).one<double>("f");
}

Problem wrong(const std::string& text) {
  const Problems problems = formula(text).problems("f");
  CAPTURE(text);
  REQUIRE(problems.size() == 1);
  return problems.front();
}

}  // namespace

TEST_CASE("An open range holds both ends exactly, whatever the step rounds to") {
  for (const int count : {2, 3, 7, 11, 96, 1000}) {
    for (const auto& [first, last] : {std::pair{0.1, 0.7}, {-3.0, 1.0 / 3}, {1e-3, 1e9}, {5.0, -5.0}, {2.0, 2.0}}) {
      const std::vector<double> values = range(first, last, count, false);
      CAPTURE(count, first, last);
      REQUIRE(values.size() == static_cast<std::size_t>(count));
      CHECK(values.front() == first);
      CHECK(values.back() == last);
      CHECK((first < last ? std::is_sorted(values.begin(), values.end())
                          : std::is_sorted(values.rbegin(), values.rend())));
    }
  }
  CHECK(range(3, 4, 1, false) == std::vector<double>{3});
}

TEST_CASE("A closed range leaves its end out") {
  CHECK(range(0, 1, 4, true) == std::vector<double>{0, 0.25, 0.5, 0.75});
  CHECK(range(3, 4, 1, true) == std::vector<double>{3});
}

TEST_CASE("A range's axis is called after its node unless it is named") {
  CatalogueGraph graph =
      graph_of({{"k", make("range", {{"count", 3}, {"closed", true}})},
                {"j", make("range", {{"count", 2}, {"axis", "t"}})},
                {"sum", make("expression", {{"formula", "x + 10 * y"}, {"x", from("k")}, {"y", from("j")}})}});
  CHECK(graph.json("sum")["axes"] ==
        Json::parse(R"([{"name": "k", "size": 3, "closed": true}, {"name": "t", "size": 2, "closed": false}])"));
  CHECK(graph.all<double>("sum")[5] == 2.0 / 3 + 10);
}

TEST_CASE("A list joins literals and links of one type along a new axis") {
  CatalogueGraph graph = graph_of({{"n", make("number", {{"value", 2.5}})},
                                   {"numbers", make("list", {{"items", {1, from("n"), -4}}})},
                                   {"points", make("list", {{"items", {{1, 2, 3}, {4, 5, 6}}}, {"axis", "p"}})},
                                   {"v", make("vector", {{"x", from("numbers")}, {"z", 1}})}});
  CHECK(graph.all<double>("numbers") == std::vector<double>{1, 2.5, -4});
  CHECK(graph.all<Point>("points") == std::vector<Point>{{1, 2, 3}, {4, 5, 6}});
  CHECK(graph.json("points")["axes"][0]["name"] == "p");
  CHECK(graph.all<Vector>("v") == std::vector<Vector>{{1, 0, 1}, {2.5, 0, 1}, {-4, 0, 1}});
}

TEST_CASE("Formulas follow the usual order of operators") {
  CHECK(formula_value("1 + 2 * 3 ^ 2") == 19);
  CHECK(formula_value("2 ^ 3 ^ 2") == 512);
  CHECK(formula_value("-x ^ 2", 3) == -9);
  CHECK(formula_value("(x - y) / z * w", 7, 1, 3, 5) == 10);
  CHECK(formula_value("x < y && y <= z || w", 1, 2, 2, 0) == 1);
  CHECK(formula_value("x > 0 ? y : z", -1, 5, 6) == 6);
  CHECK(formula_value("(x == 2) + (x != 2) + (y >= 3)", 2, 3) == 2);
  CHECK(formula_value("1.5e3 + .5") == 1500.5);
}

TEST_CASE("Functions of formulas have their usual values") {
  for (const double x : {-1.7, -0.5, 0.0, 0.3, 0.9, 2.0, 30.0}) {
    CAPTURE(x);
    const auto agrees = [&](const std::string& text, double expected) {
      CAPTURE(text);
      CHECK(std::abs(formula_value(text, x, 0.7) - expected) <= 4e-16 * std::max(1.0, std::abs(expected)));
    };
    agrees("sin(x)", std::sin(x));
    agrees("cos(x)", std::cos(x));
    agrees("tan(x)", std::tan(x));
    agrees("atan(x)", std::atan(x));
    agrees("atan2(x, y)", std::atan2(x, 0.7));
    agrees("exp(x)", std::exp(x));
    agrees("sinh(x)", std::sinh(x));
    agrees("cosh(x)", std::cosh(x));
    agrees("tanh(x)", std::tanh(x));
    agrees("asinh(x)", std::asinh(x));
    agrees("cbrt(x)", std::cbrt(x));
    agrees("hypot(x, y)", std::hypot(x, 0.7));
    agrees("floor(x)", std::floor(x));
    agrees("ceil(x)", std::ceil(x));
    agrees("round(x)", std::round(x));
    agrees("abs(x)", std::abs(x));
    agrees("sign(x)", x > 0 ? 1 : x < 0 ? -1 : 0);
    agrees("min(x, y)", std::min(x, 0.7));
    agrees("max(x, y)", std::max(x, 0.7));
    agrees("mod(x, y)", x - 0.7 * std::floor(x / 0.7));
    if (x < -1 || x > 1) continue;
    agrees("asin(x)", std::asin(x));
    agrees("acos(x)", std::acos(x));
    agrees("atanh(x)", std::atanh(x));
  }
  CHECK(formula_value("ln(e) + log10(1000) + log2(8) + log(e ^ 2)") == Approx(9).epsilon(1e-15));
  CHECK(formula_value("acosh(2)") == Approx(std::acosh(2.0)).epsilon(1e-15));
  CHECK(formula_value("pow(2, 0.5) - sqrt(2)") == Approx(0).margin(1e-15));
  CHECK(formula_value("pi") == 3.14159265358979323846);
}

TEST_CASE("A formula that cannot be read is a problem with its place") {
  for (const auto& [text, reason] : {std::pair{"1 + * 2", "at character 5: unexpected token \"* 2\""},
                                     {"sin(x", "at character 6: missing parenthesis"},
                                     {"x + q", "at character 5: unexpected token \"q\""},
                                     {"2 2", "at character 3: unexpected value \"2\""},
                                     {"x +", "at character 4: unexpected end of expression"},
                                     {"2 \u00d7 x", "at character 3: unexpected token \"\u00d7 x\""},
                                     {"max(1) + x", "at character 6: too few parameters for function \"max\""},
                                     {"x ? 2", "at character 6: if-then-else operator is missing an else clause"}}) {
    const Problem problem = wrong(text);
    CAPTURE(text, problem.detail);
    CHECK(problem.code == "invalid-formula");
    CHECK(problem.port == "formula");
    CHECK(problem.pointer == "/nodes/f/inputs/formula");
    CHECK(problem.detail == "formula: the formula cannot be read " + std::string(reason));
  }
  CHECK(wrong("").detail == "formula: the formula is empty");
  CHECK(wrong("x, y").detail == "formula: the formula must have one value, not 2");
  CHECK(wrong(std::string(2000, '(')).code == "invalid-formula");
  CHECK(wrong(std::string(999, '(')).code == "invalid-formula");
  CHECK(wrong("x = 3").code == "invalid-formula");
  CHECK(wrong("system(1)").code == "invalid-formula");
}

TEST_CASE("A formula that cannot be read is found when the graph is checked, by whatever way it is given") {
  CHECK(codes(formula("x +").static_problems()) == std::multiset<std::string>{"invalid-formula f.formula"});
  CHECK(formula("x + 1").static_problems().empty());
}

TEST_CASE("A formula without a value for its variables is a problem with their place") {
  CatalogueGraph graph = graph_of({{"k", make("range", {{"from", 2}, {"to", -1}, {"count", 4}})},
                                   {"f", make("expression", {{"formula", "sqrt(x)"}, {"x", from("k")}})}});
  const Problems problems = graph.problems("f");
  REQUIRE(codes(problems) == std::multiset<std::string>{"non-finite f"});
  CHECK(problems.front().detail.ends_with("at index 3 of axis k"));
  CHECK(formula("1 / x").problems("f").front().code == "non-finite");
}
