// Derivatives of outputs by parameters: against closed forms, with errors that hold.

#include "fitting/gradient.h"

#include <catch2/catch.hpp>

#include "tests/fitting/parameters.h"
#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

/// How long the JSON of a GLB is: the first number behind its head, the lowest byte first.
std::size_t json_bytes(const std::string& glb) {
  std::size_t size = 0;
  for (std::size_t k = 16; k-- > 12;) size = size << 8 | static_cast<unsigned char>(glb[k]);
  return size;
}

Json graph() {
  Json all = document(
      {{"value",
        make("expression", {{"formula", "x*x*x + 2*x*y"}, {"x", {{"parameter", "a"}}}, {"y", {{"parameter", "b"}}}})},
       {"line", make("range", {{"from", 0}, {"to", {{"parameter", "a"}}}, {"count", 3}})},
       {"spot", make("vector", {{"x", from("value")}, {"y", {{"parameter", "b"}}}, {"z", 1}})},
       {"ball", make("sphere_mesh", {{"radius", {{"parameter", "b"}}}, {"segments", 12}})},
       {"ring", make("circle", {{"radius", {{"parameter", "b"}}}})},
       {"out", make("export", {{"model", from("ball")}})}});
  all["parameters"] = {
      {"a", number(1.5, -2, 2)}, {"b", number(0.75, 0.5, 2)}, {"name", {{"type", "integer"}, {"default", 3}}}};
  return all;
}

Json differentiated(GradientRequest request) {
  request.graph = engine().read(graph());
  const auto found = fitting::gradient(engine(), request, Cancel());
  require_none(found ? Problems() : found.problems());
  return to_json(*found);
}

void check_slope(const Json& derivative, std::size_t index, double truth) {
  const double error = derivative["error"];
  CHECK(error < 1e-6);
  CHECK(std::abs(derivative["values"][index].get<double>() - truth) <= error);
}

std::string refusal(GradientRequest request) {
  request.graph = engine().read(graph());
  const auto found = fitting::gradient(engine(), request, Cancel());
  REQUIRE_FALSE(found);
  return found.problems().front().code + " " + found.problems().front().pointer.value_or("");
}

}  // namespace

TEST_CASE("Derivatives of a formula are those of its closed form, within the error that is told") {
  for (const double a : {-2.0, -0.3, 0.0, 1.1, 2.0}) {
    for (const double b : {0.5, 0.9, 2.0}) {
      const Json found = differentiated({.parameters = {{"a", a}, {"b", b}}, .of = {"value", "line", "spot"}});
      CAPTURE(found.dump(1));
      CHECK(found["at"] == Json{{"a", a}, {"b", b}});
      const Json& value = found["of"]["value"]["by"];
      check_slope(value["a"], 0, 3 * a * a + 2 * b);
      check_slope(value["b"], 0, 2 * a);
      for (std::size_t i = 0; i < 3; ++i) check_slope(found["of"]["line"]["by"]["a"], i, 0.5 * static_cast<double>(i));
      CHECK(found["of"]["spot"]["by"]["b"]["values"][0][1].get<double>() == Approx(1).margin(1e-9));
      CHECK(found["of"]["spot"]["by"]["b"]["values"][0][2] == 0);
    }
  }
}

TEST_CASE(
    "Vertices of a ball move along their own direction as its radius grows, and not with what it does not hang on") {
  const Json found = differentiated({.of = {"ball"}, .by = {}});
  const Json& by = found["of"]["ball"]["by"];
  REQUIRE(by["b"]["values"].size() > 20);
  for (const Json& motion : by["b"]["values"]) {
    CHECK(std::hypot(motion[0].get<double>(), motion[1].get<double>(), motion[2].get<double>()) ==
          Approx(1).margin(1e-9));
  }
  for (const Json& motion : by["a"]["values"]) CHECK(motion == Json::array({0.0, 0.0, 0.0}));
}

TEST_CASE("A model in the colors of its motion has a color at every vertex and says how fast it is") {
  const GradientRequest request{.graph = engine().read(graph()), .of = {}, .by = {"b"}};
  const auto found = fitting::gradient(engine(), request, Cancel());
  REQUIRE(found);
  const auto file = fitting::colored(*found, Cancel());
  REQUIRE(file);
  const Json json = Json::parse(file->substr(20, json_bytes(*file)));
  CHECK(json["asset"]["extras"]["gradient"]["parameter"] == "b");
  CHECK(json["asset"]["extras"]["gradient"]["fastest"] == Approx(1));
  for (const Json& mesh : json["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) CHECK(primitive["attributes"].contains("COLOR_0"));
  }
  const auto two = fitting::gradient(engine(), {.graph = request.graph}, Cancel());
  REQUIRE(two);
  CHECK(fitting::colored(*two, Cancel()).problems().front().pointer == "/by");
}

TEST_CASE(
    "Derivatives that do not fit into memory together are taken one parameter after the other, and are the same") {
  const GradientRequest request{.graph = engine().read(graph()), .of = {"value", "ball", "value"}, .by = {"a", "b"}};
  const auto bytes = fitting::check(engine(), request, Cancel());
  REQUIRE(bytes);
  Limits limits;
  limits.request_bytes = *bytes / 2;
  const std::unique_ptr<Engine> small = make_engine(limits);
  GradientRequest same = request;
  same.graph = small->read(graph());
  const auto all = fitting::gradient(engine(), request, Cancel()), some = fitting::gradient(*small, same, Cancel());
  REQUIRE(all);
  REQUIRE(some);
  CHECK(to_json(*all) == to_json(*some));
  REQUIRE(all->outputs.size() == 3);
  CHECK(all->outputs[2].by[0].slopes == all->outputs[0].by[0].slopes);
}

TEST_CASE("More derivatives than memory holds are refused") {
  Limits limits;
  const std::unique_ptr<Engine> first = make_engine(limits);
  GradientRequest request{.graph = first->read(graph()), .of = {"value"}, .by = {"a"}};
  const auto one = fitting::check(*first, request, Cancel());
  REQUIRE(one);
  limits.request_bytes = *one / 5;  // four values beside the one that is there
  const std::unique_ptr<Engine> small = make_engine(limits);
  request.graph = small->read(graph());
  CHECK(fitting::gradient(*small, request, Cancel()));
  Json large = graph();
  large["nodes"]["line"]["inputs"]["count"] = 10'000;
  request.of = {"line"};
  request.graph = small->read(large);
  const auto refused = fitting::gradient(*small, request, Cancel());
  REQUIRE_FALSE(refused);
  CHECK(refused.problems().front().code == "limit-exceeded");
}

TEST_CASE("What has no derivative is refused at its place") {
  CHECK(refusal({.of = {"value"}, .by = {"c"}}) == "unknown-parameter /by/0");
  CHECK(refusal({.of = {"value"}, .by = {"a", "name"}}) == "type-mismatch /by/1");
  CHECK(refusal({.of = {"value", "ring"}}) == "type-mismatch /of/1");
  CHECK(refusal({.of = {"value", "nothing"}}) == "unknown-node /of/1");
}
