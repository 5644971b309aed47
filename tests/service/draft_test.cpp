// Drafts keep to the triangles they are given.

#include <catch2/catch.hpp>

#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

const Engine& examples_engine() {
  static const std::unique_ptr<Engine> one = example_engine();
  return *one;
}

/// Meshes of every kind that a draft may thin, on one export.
Json large_graph() {
  return document({{"k", make("range", {{"to", 3}, {"count", 400}})},
                   {"ring", make("circle", {{"radius", from("k")}})},
                   {"skin", make("surface", {{"shape", from("ring")}, {"segments", 256}})},
                   {"wire", make("circle", {{"radius", 5}})},
                   {"dots", make("sample", {{"shape", from("wire")}, {"count", 4000}})},
                   {"hose", make("tube", {{"shape", from("dots")}, {"sides", 32}})},
                   {"hoop", make("tube", {{"shape", from("wire")}, {"segments", 512}, {"sides", 32}})},
                   {"ball", make("sphere_mesh", {{"segments", 256}, {"rings", 128}})},
                   {"donut", make("torus_mesh", {{"segments", 256}, {"sides", 128}})},
                   {"box", make("box_mesh", {{"segments", 128}})},
                   {"fine", make("subdivide", {{"shape", from("box")}, {"levels", 2}})},
                   {"out", make("export", {{"model",
                                            {from("skin"), from("hose"), from("hoop"), from("ball"), from("donut"),
                                             from("box"), from("fine")}}})}});
}

Asked draft_of(Json graph, std::optional<std::int64_t> budget) {
  Asked request;
  request.graph = std::move(graph);
  request.quality = Quality::draft;
  request.triangle_budget = budget;
  return request;
}

std::size_t triangles_of(const Asked& request) {
  const Result<Answered> answer = answered(examples_engine(), request);
  require_none(answer ? Problems{} : answer.problems());
  return answer->report()["model"]["triangles"];
}

}  // namespace

TEST_CASE("A draft has about as many triangles as its budget, whatever meshes share it") {
  for (const std::int64_t budget : {1000, 5000, 20'000, 200'000}) {
    CAPTURE(budget);
    const auto triangles = static_cast<double>(triangles_of(draft_of(large_graph(), budget)));
    CHECK(triangles <= static_cast<double>(budget));
    CHECK(triangles > 0.2 * static_cast<double>(budget));
  }
  CHECK(triangles_of(draft_of(large_graph(), std::nullopt)) == triangles_of(draft_of(large_graph(), 20'000)));
}

TEST_CASE("Every example keeps to the budget of its draft, or says by how much it does not") {
  std::map<std::string, Json> all = examples();
  all.merge(examples(std::string(DINI_EXAMPLES) + "/nodes"));
  for (const auto& [id, graph] : all) {
    for (const std::int64_t budget : {100, 1000, 20'000}) {
      CAPTURE(id, budget);
      const Result<Answered> answer = answered(examples_engine(), draft_of(graph, budget));
      require_none(answer ? Problems{} : answer.problems());
      const Json report = answer->report();
      const std::int64_t triangles = report["model"]["triangles"];
      const Json said = report["warnings"];
      if (triangles <= budget) {
        CHECK(said == Json::array());
        continue;
      }
      // Only where there are very many parts does none of them go any lower.
      CHECK(budget < 20'000);
      const auto told = std::find_if(said.begin(), said.end(),
                                     [](const Json& warning) { return warning["code"] == "triangle-budget"; });
      REQUIRE(told != said.end());
      CHECK((*told)["detail"].get<std::string>().find(std::to_string(triangles) + " triangles") != std::string::npos);
    }
  }
}

TEST_CASE("Imported meshes, tubes and finer meshes are thinned to the least budget too") {
  for (const char* id : {"fig12_imported_mesh", "nodes/import", "nodes/tube", "nodes/subdivide"}) {
    CAPTURE(id);
    const Json graph = Json::parse(std::ifstream(std::string(DINI_EXAMPLES) + "/" + id + ".json"));
    CHECK(triangles_of(draft_of(graph, 100)) <= 100);
    CHECK(triangles_of(draft_of(graph, 100)) > 10);
  }
}

TEST_CASE("A mesh that a family uses counts as often as it is used") {
  const Json graph = document({{"ball", make("sphere_mesh", {{"segments", 64}, {"rings", 32}})},
                               {"k", make("range", {{"to", 9}, {"count", 10}})},
                               {"by", make("vector", {{"x", from("k")}})},
                               {"row", make("translate", {{"shape", from("ball")}, {"vector", from("by")}})},
                               {"out", make("export", {{"model", from("row")}})}});
  const std::size_t triangles = triangles_of(draft_of(graph, 10'000));
  CHECK(triangles <= 10'000);
  CHECK(triangles > 6'000);
}

TEST_CASE("A draft that fits its budget is as fine as the final answer") {
  Json graph = document({{"ball", make("sphere_mesh")}, {"out", make("export", {{"model", from("ball")}})}});
  Asked final_request = draft_of(graph, std::nullopt);
  final_request.quality = Quality::final;
  CHECK(triangles_of(draft_of(graph, 100'000)) == triangles_of(final_request));
  CHECK(triangles_of(draft_of(graph, 1000)) < 1100);
}

TEST_CASE("A budget outside its bounds, or for a final answer, is refused") {
  const auto refused = [](const Asked& request) {
    const auto prepared = prepared_for(examples_engine(), request);
    REQUIRE_FALSE(prepared);
    CHECK(prepared.problems().front().code == "out-of-range");
    CHECK(prepared.problems().front().pointer == "/triangle_budget");
    return prepared.problems().front();
  };
  for (const std::int64_t budget : {std::int64_t{99}, std::int64_t{0}, std::int64_t{-5}, std::int64_t{10'000'001}}) {
    CHECK(refused(draft_of(large_graph(), budget)).detail.find("100 to 10000000") != std::string::npos);
  }
  Asked request = draft_of(large_graph(), 1000);
  request.quality = Quality::final;
  CHECK(refused(request).detail == "a triangle_budget goes with quality draft only; a final answer is never thinned");
}

TEST_CASE("The tag of a draft depends on its budget where that thins something") {
  const auto tag = [](const Asked& request) { return (*prepared_for(examples_engine(), request))->model_tag; };
  CHECK(tag(draft_of(large_graph(), 1000)) != tag(draft_of(large_graph(), 2000)));
  CHECK(tag(draft_of(large_graph(), 1000)) == tag(draft_of(large_graph(), 1000)));
}
