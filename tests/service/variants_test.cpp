#include "service/variants.h"

#include <catch2/catch.hpp>
#include <set>

using namespace dini;

namespace {

Result<Variants> read(const SweepAxes& axes, const Json& fixed = Json::object(), std::size_t most = 1000) {
  return Variants::read(axes, fixed, most);
}

/// "code pointer" of every problem.
std::set<std::string> faults(const SweepAxes& axes, const Json& fixed = Json::object(), std::size_t most = 1000) {
  const Result<Variants> variants = read(axes, fixed, most);
  REQUIRE_FALSE(variants);
  std::set<std::string> all;
  for (const Problem& problem : variants.problems()) {
    CHECK(problem.in_request);
    all.insert(problem.code + " " + problem.pointer.value_or(""));
  }
  return all;
}

}  // namespace

TEST_CASE("A grid combines all values, the last parameter of the alphabet fastest") {
  const auto variants = read({.grid = {{"b", {1, 2}}, {"a", {"x", "y", "z"}}}});
  REQUIRE(variants);
  REQUIRE(variants->size() == 6);
  CHECK(variants->at(0) == Json{{"a", "x"}, {"b", 1}});
  CHECK(variants->at(1) == Json{{"a", "x"}, {"b", 2}});
  CHECK(variants->at(5) == Json{{"a", "z"}, {"b", 2}});
  std::set<std::string> all;
  for (std::size_t i = 0; i < variants->size(); ++i) all.insert(variants->at(i).dump());
  CHECK(all.size() == 6);
}

TEST_CASE("A zip takes the values of one place together, a list its entries") {
  const auto zipped = read({.zip = {{"a", {1, 2}}, {"b", {{0, 0, 1}, {0, 1, 0}}}}});
  REQUIRE(zipped);
  REQUIRE(zipped->size() == 2);
  CHECK(zipped->at(1) == Json{{"a", 2}, {"b", {0, 1, 0}}});
  const auto listed = read({.list = {{{"a", 1}}, Json::object(), {{"b", true}}}});
  REQUIRE(listed);
  REQUIRE(listed->size() == 3);
  CHECK(listed->at(1) == Json::object());
  CHECK(listed->at(2) == Json{{"b", true}});
}

TEST_CASE("Exactly one of grid, zip and list is given") {
  CHECK(faults({}) == std::set<std::string>{"required-input-missing "});
  CHECK(faults({.grid = {{"a", {1}}}, .list = Json::array({Json::object()})}) ==
        std::set<std::string>{"required-input-missing "});
}

TEST_CASE("What cannot be swept is told with its place") {
  CHECK(faults({.grid = Json::object()}) == std::set<std::string>{"required-input-missing /grid"});
  CHECK(faults({.grid = {{"a", Json::array()}, {"b", 3}, {"c/d", {1}}}}, {{"c/d", 1}}) ==
        std::set<std::string>{"required-input-missing /grid/a", "type-mismatch /grid/b", "out-of-range /grid/c~1d"});
  CHECK(faults({.zip = {{"a", {1, 2}}, {"b", {1}}}}) == std::set<std::string>{"axis-mismatch /zip/b"});
  CHECK(faults({.list = Json::array()}) == std::set<std::string>{"required-input-missing /list"});
  CHECK(faults({.list = {{{"a", 1}}, {{"b", 1}}}}, {{"b", 2}}) == std::set<std::string>{"out-of-range /list/1/b"});
}

TEST_CASE("The number of variants is bounded, however large the product") {
  Json values = Json::array();
  for (int i = 0; i < 100; ++i) values.push_back(i);
  CHECK(read({.grid = {{"a", values}, {"b", Json::array({1, 2, 3, 4, 5, 6, 7, 8, 9, 10})}}}));
  CHECK(faults({.grid = {{"a", values}, {"b", values}}}) == std::set<std::string>{"limit-exceeded /grid"});
  Json many = Json::object();
  for (int i = 0; i < 40; ++i) many["p" + std::to_string(i)] = values;
  CHECK(faults({.grid = many}) == std::set<std::string>{"limit-exceeded /grid"});
}
