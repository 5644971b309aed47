// What a report tells of the parts of a model.

#include <catch2/catch.hpp>

#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

Json boxes_and_more() {
  return document(
      {{"side", make("range", {{"from", 1}, {"to", 2}, {"count", 2}, {"axis", "side"}})},
       {"box", make("box_mesh", {{"center", {5, 0, 0}}, {"segments", 2}})},
       {"boxes", make("scale", {{"shape", from("box")}, {"factor", from("side.values")}})},
       {"sheet", make("grid", {{"count_u", 3}, {"count_v", 4}})},
       {"skin", make("surface", {{"shape", from("sheet.points")}})},
       {"ring", make("circle")},
       {"out", make("export", {{"model", {from("boxes"), from("skin"), from("ring"), from("sheet.points")}}})}});
}

std::shared_ptr<const Answered> answer_of(const Engine& engine, const Asked& asked) {
  Result<Answered> answer = answered(engine, asked);
  require_none(answer ? Problems{} : answer.problems());
  return std::make_shared<const Answered>(*std::move(answer));
}

Problem only_problem(const Engine& engine, const Asked& asked) {
  const auto prepared = prepared_for(engine, asked);
  REQUIRE_FALSE(prepared);
  REQUIRE(prepared.problems().size() == 1);
  return prepared.problems().front();
}

}  // namespace

TEST_CASE("A report tells of each part of a model whether it is a solid, and how large") {
  const std::unique_ptr<Engine> engine = example_engine();
  const Json parts = answer_of(*engine, {.graph = boxes_and_more(), .parts = true})->report()["parts"];
  REQUIRE(parts.size() == 5);
  for (const int i : {0, 1}) {
    const double side = i + 1;
    const Json& box = parts[static_cast<std::size_t>(i)];
    CHECK(box["name"] == "boxes[" + std::to_string(i) + "]");
    CHECK(box["type"] == "mesh");
    CHECK(box["watertight"] == true);
    CHECK(box["boundary_loops"] == 0);
    CHECK(box["components"] == 1);
    CHECK(box["self_intersections"] == 0);
    CHECK(box["vertices"] == 26);
    CHECK(box["triangles"] == 48);
    CHECK(box["volume"].get<double>() == Approx(side * side * side));
    CHECK(box["area"].get<double>() == Approx(6 * side * side));
    CHECK(box["least_thickness"].get<double>() == Approx(side));
    CHECK(box["center_of_mass"][0].get<double>() == Approx(5 * side));
    CHECK(box["inertia"][2].get<double>() == Approx(std::pow(side, 5) / 6));
  }
  CHECK(parts[2]["name"] == "skin");
  CHECK(parts[2]["watertight"] == false);
  CHECK(parts[2]["boundary_loops"] == 1);
  CHECK(parts[3] == Json{{"name", "ring"}, {"type", "circle"}, {"count", 1}});
  CHECK(parts[4] == Json{{"name", "sheet"}, {"type", "point"}, {"count", 12}});
}

TEST_CASE("Parts are told only to who asks, change no file, and are known the second time") {
  const std::unique_ptr<Engine> engine = example_engine();
  const Json graph = boxes_and_more();
  const auto plain = answer_of(*engine, {.graph = graph});
  CHECK_FALSE(plain->report().contains("parts"));
  const Asked asked{.graph = graph, .parts = true};
  const auto prepared = prepared_for(*engine, asked);
  REQUIRE(prepared);
  CHECK(engine->find(**prepared) == nullptr);
  const auto told = answer_of(*engine, asked);
  CHECK(*told->glb == *plain->glb);
  const SharedComputed found = engine->find(**prepared);
  REQUIRE(found != nullptr);
  CHECK(engine->report(**prepared, *found)["parts"] == told->report()["parts"]);
}

TEST_CASE("Parts without a model are refused, and more than a report can tell") {
  Limits limits;
  limits.measured_values = 4;
  const std::unique_ptr<Engine> engine = example_engine(limits);
  const Problem none = only_problem(*engine, {.graph = boxes_and_more(), .preview = {"ring"}, .parts = true});
  CHECK(none.code == "unknown-output");
  CHECK(none.pointer == "/parts");
  const Problem many = only_problem(*engine, {.graph = boxes_and_more(), .parts = true});
  CHECK(many.code == "limit-exceeded");
  CHECK(many.pointer == "/parts");
  CHECK(many.detail.find("5 parts") != std::string::npos);
}
