#include "graph/document.h"

#include <catch2/catch.hpp>

#include "graph/json_reader.h"
#include "graph/registry.h"
#include "tests/support/graphs.h"

using namespace dini;

namespace {

const Limits usual_limits;

std::multiset<std::string> pointers(const Json& json) {
  const Result<Document> read = read_document(json, usual_limits, Registry());
  std::multiset<std::string> all;
  if (read) return all;
  for (const Problem& problem : read.problems()) all.insert(problem.code + " " + problem.pointer.value_or("nowhere"));
  return all;
}

}  // namespace

TEST_CASE("Writing what was read gives the same document") {
  const Json json = Json::parse(R"({
    "format": 1,
    "meta": {"title": "Everything", "anything": [1, {"goes": null}]},
    "parameters": {
      "n": {"type": "number", "default": 1.5, "min": 0, "max": 4, "step": 0.01, "unit": "m", "label": "N", "description": "A number."},
      "i": {"type": "integer", "default": 3},
      "b": {"type": "boolean", "default": true},
      "c": {"type": "choice", "default": "exact", "choices": ["exact", "paper"]},
      "v": {"type": "vector", "default": [0, 0, 1]},
      "k": {"type": "color", "default": [0.1, 0.2, 0.3, 1]}
    },
    "nodes": {
      "a": {"type": "number", "inputs": {"value": {"parameter": "n"}}},
      "b": {"type": "list", "inputs": {"items": [{"from": "a"}, {"from": "a.value"}, 3], "axis": "k"}, "bypass": true},
      "c": {"type": "vector"}
    },
    "ui": {"nodes": {"a": {"x": 1, "y": 2}}}
  })");
  const Result<Document> read = read_document(json, usual_limits, Registry());
  REQUIRE(read.has_value());
  CHECK(write_document(*read) == json);
  const Result<Document> again = read_document(write_document(*read), usual_limits, Registry());
  REQUIRE(again.has_value());
  CHECK(*again == *read);
}

TEST_CASE("A document may say where its schema is, and keeps it") {
  const Json json = {{"$schema", "/schema/graph-1.json"}, {"format", 1}, {"nodes", Json::object()}};
  const Result<Document> read = read_document(json, usual_limits, Registry());
  REQUIRE(read);
  CHECK(write_document(*read) == json);
  CHECK(pointers({{"$schema", 1}, {"format", 1}, {"nodes", Json::object()}}) ==
        std::multiset<std::string>{"type-mismatch /$schema"});
}

TEST_CASE("Unknown members anywhere are errors with the nearest known name") {
  CHECK(pointers(Json::parse(R"({"format": 1, "nods": {}, "nodes": {}})")) ==
        std::multiset<std::string>{"unknown-member /nods"});
  CHECK(pointers(Json::parse(R"({"format": 1, "nodes": {"a": {"type": "number", "input": {}}}})")) ==
        std::multiset<std::string>{"unknown-member /nodes/a/input"});
  CHECK(pointers(Json::parse(
            R"({"format": 1, "nodes": {}, "parameters": {"p": {"type": "number", "default": 1, "maximum": 2}}})")) ==
        std::multiset<std::string>{"unknown-member /parameters/p/maximum"});
  CHECK(pointers(
            Json::parse(R"({"format": 1, "nodes": {"a": {"type": "number", "inputs": {"value": {"form": "b"}}}}})")) ==
        std::multiset<std::string>{"type-mismatch /nodes/a/inputs/value"});
  CHECK(pointers(Json::parse(
            R"({"format": 1, "nodes": {"a": {"type": "number", "inputs": {"value": {"from": "b", "x": 1}}}}})")) ==
        std::multiset<std::string>{"type-mismatch /nodes/a/inputs/value"});
}

TEST_CASE("Ids, formats and parameter defaults are checked") {
  CHECK(pointers(Json::parse(
            R"({"format": 3, "nodes": {"1a": {"type": "number"}, "a.b": {"type": "number"}, "": {"type": "x"}}})")) ==
        std::multiset<std::string>{"invalid-id /nodes/", "invalid-id /nodes/1a", "invalid-id /nodes/a.b",
                                   "unsupported-format /format"});
  CHECK(pointers(Json::parse(R"({"nodes": []})")) ==
        std::multiset<std::string>{"required-member-missing ", "type-mismatch /nodes"});
  CHECK(pointers(Json::parse(R"({"format": 1, "nodes": {}, "parameters": {
    "a": {"type": "number", "default": 5, "max": 4},
    "b": {"type": "choice", "default": "x", "choices": ["y"]},
    "c": {"type": "mesh", "default": 1},
    "d": {"type": "number"}}})")) ==
        std::multiset<std::string>{"out-of-range /parameters/a/default", "not-in-choices /parameters/b/default",
                                   "required-member-missing /parameters/d", "type-mismatch /parameters/c/type"});
  CHECK(pointers(Json::parse(R"({"format": 1, "nodes": {"n": {"type": 7}}, "parameters": {
    "a": {"type": "number", "default": 5, "min": 4, "max": 3},
    "b": {"type": "number", "default": 5, "step": 0},
    "c": {"type": "number", "default": 5, "step": -1}}})")) ==
        std::multiset<std::string>{"type-mismatch /nodes/n/type", "out-of-range /parameters/a/min",
                                   "out-of-range /parameters/b/step", "out-of-range /parameters/c/step"});
  CHECK(pointers(Json(3)) == std::multiset<std::string>{"type-mismatch "});
}

TEST_CASE("A graph with too many nodes is refused as a whole") {
  Json json = {{"format", 1}, {"nodes", Json::object()}};
  for (std::size_t i = 0; i <= usual_limits.nodes; ++i) json["nodes"]["n" + std::to_string(i)] = {{"type", "number"}};
  CHECK(pointers(json) == std::multiset<std::string>{"limit-exceeded /nodes"});
}

TEST_CASE("The reader refuses what is not strict JSON") {
  const auto code = [](std::string_view text) {
    const Result<Json> read = parse_json(text, usual_limits);
    return read ? std::string("read") : read.problems().front().code;
  };
  CHECK(code(R"({"a": [1, -2.5e3, "x", true, null]})") == "read");
  for (const std::string_view text :
       {R"({"a": 1, "a": 2})", R"({"a": )", R"([1] [2])", R"([NaN])", R"([Infinity])", R"([1e400])", R"([01])",
        R"([1.])", R"([1,])", "// x\n1", "[\"\xFF\"]", "", "{\"a\\u0001b\": 1}", R"(["a\u0000b"])", "['a']"}) {
    CAPTURE(text);
    CHECK(code(text) == "not-json");
  }
  CHECK(code(std::string("[1]\0[2]", 7)) == "not-json");
  CHECK(code(std::string(32, '[') + std::string(32, ']')) == "read");
  CHECK(code(std::string(33, '[') + std::string(33, ']')) == "not-json");
  CHECK(code(std::string(1'000'000, '[')) == "not-json");
  CHECK(code("[\"" + std::string(usual_limits.string_bytes + 1, 'a') + "\"]") == "limit-exceeded");
  std::string many = "[0";
  for (std::size_t i = 0; i < usual_limits.json_values; ++i) many += ",0";
  CHECK(code(many + "]") == "limit-exceeded");
}
