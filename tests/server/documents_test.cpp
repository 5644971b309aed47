// Documents as strangers send them, to the real engine: each is refused for what it is, before it costs anything.

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/server/fixture.h"
#include "tests/support/damage.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A document that is refused, as the text of a body of /v1/evaluate.
struct Refused {
  std::string title;
  std::string body;
  std::string code;
};

std::string repeated_text(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

/// A request with a graph of these nodes; `out` exports the node `a`.
std::string body_of(Json nodes) {
  nodes["out"] = {{"type", "export"}, {"inputs", {{"model", {{"from", "a"}}}}}};
  return Json{{"graph", {{"format", 1}, {"nodes", std::move(nodes)}}}}.dump();
}

Json node(const char* type, Json inputs) { return {{"type", type}, {"inputs", std::move(inputs)}}; }

std::string ball_of(const std::string& radius) {
  const std::string body = body_of({{"a", node("sphere_mesh", {{"radius", "RADIUS"}})}});
  return body.substr(0, body.find("\"RADIUS\"")) + radius + body.substr(body.find("\"RADIUS\"") + 8);
}

std::vector<Refused> texts() {
  const std::string good = ball_of("1");
  return {
      {"nothing", "", "not-json"},
      {"half of a document", good.substr(0, good.size() / 2), "not-json"},
      {"text behind it", good + " x", "not-json"},
      {"NUL behind it", good + std::string(1, '\0') + "[2]", "not-json"},
      {"bytes that are no UTF-8", ball_of("\"\xff\xfe\""), "not-json"},
      {"an overlong UTF-8", ball_of("\"\xc0\xaf\""), "not-json"},
      {"one level too deep", repeated_text("[", 33) + repeated_text("]", 33), "not-json"},
      {"a million levels", repeated_text("[", 1'000'000), "not-json"},
      {"objects of great depth", repeated_text("{\"a\":", 100'000), "not-json"},
      {"too many values", "[" + repeated_text("0,", 200'000) + "0]", "limit-exceeded"},
      {"a text of 1 MB", ball_of("\"" + std::string(1'000'000, 'x') + "\""), "limit-exceeded"},
      {"a name twice", R"({"graph": {}, "graph": {}})", "not-json"},
      {"NaN", ball_of("NaN"), "not-json"},
      {"infinity", ball_of("Infinity"), "not-json"},
      {"a number past every range", ball_of("1e400"), "not-json"},
      {"a number of a million digits", ball_of(std::string(1'000'000, '9')), "not-json"},
      {"a number in hexadecimal", ball_of("0x10"), "not-json"},
      {"a comment", "/* */" + good, "not-json"},
      {"a list", "[]", "type-mismatch"},
      {"a name that nobody knows", R"({"graph": {}, "grahp": {}})", "unknown-member"},
  };
}

std::vector<Refused> values() {
  const auto count = [](const std::string& value) {
    return R"({"graph":{"format":1,"nodes":{"k":{"type":"range","inputs":{"count":)" + value +
           R"(}},"a":{"type":"sphere_mesh","inputs":{"radius":{"from":"k"}}},)"
           R"("out":{"type":"export","inputs":{"model":{"from":"a"}}}}}})";
  };
  return {
      {"a count that is past 2^53", count("9007199254740993"), "out-of-range"},
      {"a count that is 2^64", count("18446744073709551616"), "out-of-range"},
      {"a count below zero", count("-1"), "out-of-range"},
      {"half a count", count("3.7"), "type-mismatch"},
      {"true for a count", count("true"), "type-mismatch"},
      {"a text for a count", count("\"7\""), "type-mismatch"},
      {"a text for a number", ball_of("\"7\""), "type-mismatch"},
      {"true for a number", ball_of("true"), "type-mismatch"},
      {"a list for a number", ball_of("[1]"), "type-mismatch"},
      {"a number that is too large to draw", ball_of("1e30"), "out-of-range"},
      {"more samples than there may be", count("1000000000"), "out-of-range"},
      {"a product that is more than there may be",
       body_of({{"i", node("range", {{"count", 100'000}, {"axis", "i"}})},
                {"j", node("range", {{"count", 100'000}, {"axis", "j"}})},
                {"p", node("vector", {{"x", {{"from", "i"}}}, {"y", {{"from", "j"}}}})},
                {"a", node("sphere_mesh", {{"center", {{"from", "p"}}}})}}),
       "limit-exceeded"},
  };
}

std::vector<Refused> graphs() {
  Json many = Json::object();
  for (int i = 0; i < 2001; ++i) many["n" + std::to_string(i)] = node("number", {{"value", i}});
  const Json links(10'000, Json{{"from", "c"}});
  return {
      {"a node that feeds itself", body_of({{"a", node("sphere_mesh", {{"radius", {{"from", "a"}}}})}}),
       "graph-has-cycle"},
      {"a circle of nodes",
       body_of({{"a", node("translate", {{"shape", {{"from", "b"}}}})},
                {"b", node("translate", {{"shape", {{"from", "a"}}}})}}),
       "graph-has-cycle"},
      {"a link to nothing", body_of({{"a", node("translate", {{"shape", {{"from", "nowhere"}}}})}}), "dangling-link"},
      {"a wire of another type",
       body_of({{"c", node("circle", Json::object())}, {"a", node("sphere_mesh", {{"radius", {{"from", "c"}}}})}}),
       "type-mismatch"},
      {"a node that nobody knows", body_of({{"a", node("sphere_mash", Json::object())}}), "unknown-node-type"},
      {"an input that nobody knows", body_of({{"a", node("sphere_mesh", {{"radios", 1}})}}), "unknown-port"},
      {"an id with markup", body_of({{"<b>a</b>", node("sphere_mesh", Json::object())}}), "invalid-id"},
      {"an id that scripts take for something else", body_of({{"__proto__", node("sphere_mesh", Json::object())}}),
       "invalid-id"},
      {"too many nodes", body_of(std::move(many)), "limit-exceeded"},
      {"more links than there may be",
       body_of({{"c", node("number", Json::object())}, {"a", node("list", {{"items", links}})}}), "limit-exceeded"},
      {"a file of this machine", body_of({{"a", node("import", {{"asset", "/etc/passwd"}})}}), "unknown-asset"},
      {"an address to fetch", body_of({{"a", node("import", {{"asset", "http://127.0.0.1/a.obj"}})}}), "unknown-asset"},
  };
}

}  // namespace

TEST_CASE("What strangers send is refused for what it is, before it costs anything") {
  const RunningReal server;
  for (const auto& table : {texts(), values(), graphs()}) {
    for (const Refused& refused : table) {
      CAPTURE(refused.title);
      const auto answer = post(server.port(), "/v1/evaluate", refused.body);
      REQUIRE(answer);
      CAPTURE(answer->body.substr(0, 300));
      CHECK(answer->status == (refused.code == "not-json" ? 400 : 422));
      CHECK(answer->header("content-type") == "application/problem+json");
      CHECK(answer->code() == refused.code);
      CHECK(answer->json()["detail"].get<std::string>().size() <= 400);
    }
  }
  CHECK(post(server.port(), "/v1/evaluate", ball_of("1"))->status == 200);
}

TEST_CASE("A graph whose paths double at every node is read in one go") {
  const RunningReal server;
  Json nodes = {{"n0", node("number", {{"value", 1}})}};
  for (int i = 1; i <= 64; ++i) {
    const Json last = {{"from", "n" + std::to_string(i - 1)}};
    nodes["n" + std::to_string(i)] = node("expression", {{"formula", "(x + y) / 2"}, {"x", last}, {"y", last}});
  }
  nodes["a"] = node("sphere_mesh", {{"radius", {{"from", "n64"}}}});
  CHECK(post(server.port(), "/v1/evaluate", body_of(std::move(nodes)))->status == 200);
}

TEST_CASE("Damaged documents are evaluated or refused, and nothing worse") {
  auto settings = quick_settings();
  settings.compute_queue = 8;
  dini::Limits limits;
  limits.vertices = 60'000;
  const RunningReal server(settings, limits);
  std::mt19937 random(23);
  std::ifstream file(DINI_EXAMPLES "/fig04_boosted_ring.json");
  const std::string good =
      R"({"graph":)" + std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()) + "}";
  std::set<int> seen;
  for (int i = 0; i < 400; ++i) {
    const std::string body = damaged(good, random);
    const auto answer = post(server.port(), "/v1/evaluate", body);
    CAPTURE(body);
    REQUIRE(answer);
    seen.insert(answer->status);
    CHECK((answer->status == 200 || answer->status == 400 || answer->status == 422));
    if (answer->status != 200) CHECK(answer->header("content-type") == "application/problem+json");
  }
  CHECK(seen == std::set<int>{200, 400, 422});
  CHECK(post(server.port(), "/v1/evaluate", ball_of("1"))->status == 200);
}
