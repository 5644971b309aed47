// The same request gives the same bytes, however it is computed.

#include <catch2/catch.hpp>
#include <set>
#include <tbb/global_control.h>
#include <thread>

#include "algebra/kernels.h"
#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

Asked request_for(const Json& graph, Json parameters = Json::object(), Quality quality = Quality::final) {
  return {.graph = graph, .parameters = std::move(parameters), .output = "", .quality = quality};
}

Asked draft_for(const Json& graph, Json parameters = Json::object()) {
  return request_for(graph, std::move(parameters), Quality::draft);
}

/// The draft from an engine that has computed nothing before. Final files, which take minutes with sanitizers, are held
/// to be the same by scripts/lib/file_hashes.mjs.
std::string fresh_draft(const Json& graph) { return file_of(*example_engine(), draft_for(graph)); }

/// Puts the choice of instruction set back.
struct RestoreInstructionSet {
  ~RestoreInstructionSet() { kernels::force_instruction_set(""); }
};

/// A graph with an `amount` that all its results depend on.
Json small_graph() {
  Json graph = document(
      {{"ball", make("sphere_mesh", {{"segments", 32}, {"rings", 16}})},
       {"pair", make("point_pair", {{"position", {2, 0, 0}}})},
       {"moved",
        make("boost", {{"shape", from("ball")}, {"generator", from("pair")}, {"amount", {{"parameter", "amount"}}}})},
       {"out", make("export", {{"model", from("moved")}})}});
  graph["parameters"] = {{"amount", {{"type", "number"}, {"default", 0.1}, {"min", 0}, {"max", 1}}}};
  return graph;
}

}  // namespace

TEST_CASE("Drafts are the same with one thread and with several") {
  for (const auto& [id, graph] : examples()) {
    CAPTURE(id);
    std::set<std::string> files;
    for (const std::size_t threads : {1, 2, 4}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      files.insert(fresh_draft(graph));
    }
    CHECK(files.size() == 1);
  }
}

TEST_CASE("Drafts are the same with the lowest and the highest instruction set") {
  const RestoreInstructionSet restore;
  for (const auto& [id, graph] : examples()) {
    CAPTURE(id);
    std::set<std::string> files;
    for (const char* name : {kernels::instruction_sets().front(), kernels::instruction_sets().back()}) {
      REQUIRE(kernels::force_instruction_set(name));
      files.insert(fresh_draft(graph));
    }
    CHECK(files.size() == 1);
  }
}

TEST_CASE("Previews of every node of the examples can be drawn and are the same everywhere") {
  const RestoreInstructionSet restore;
  const auto lowest = kernels::instruction_sets().back();
  for (const auto& [id, graph] : examples()) {
    CAPTURE(id);
    Asked request = draft_for(graph);
    for (const auto& [node, entry] : graph["nodes"].items()) {
      if (request.preview.size() < Limits().previews) request.preview.push_back(node);
    }
    std::set<std::string> files;
    for (const char* set : {"", lowest}) {
      REQUIRE(kernels::force_instruction_set(set));
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, set == lowest ? 1 : 4);
      const Result<Answered> answer = answered(*example_engine(), request);
      require_none(answer ? Problems{} : answer.problems());
      files.insert(*answer->preview);
    }
    CHECK(files.size() == 1);
  }
}

TEST_CASE("Drafts are the same from a cold cache, a warm one, and one that knows only parts") {
  for (const auto& [id, graph] : examples()) {
    CAPTURE(id);
    const std::unique_ptr<Engine> engine_owner = example_engine();
    const Engine& engine = *engine_owner;
    const auto parameter = graph["parameters"].items().begin();
    const Json other =
        parameter.value().contains("max") ? parameter.value()["max"] : parameter.value()["choices"].back();
    file_of(engine, draft_for(graph, {{parameter.key(), other}}));
    const std::string partly = file_of(engine, draft_for(graph));
    CHECK(partly == fresh_draft(graph));
    CHECK(partly == file_of(engine, draft_for(graph)));
  }
}

TEST_CASE("A warm cache is used") {
  const std::unique_ptr<Engine> engine_owner = example_engine();
  const Engine& engine = *engine_owner;
  const Json graph = small_graph();
  const auto cached = [&](const Json& amount) {
    const Result<Answered> answer = answered(engine, request_for(graph, {{"amount", amount}}));
    require_none(answer ? Problems{} : answer.problems());
    std::set<std::string> nodes;
    const Json report = answer->report();
    for (const auto& [id, node] : report["nodes"].items()) {
      if (node["cached"] == true) nodes.insert(id);
    }
    return nodes;
  };
  CHECK(cached(0.1).empty());
  CHECK(cached(0.1) == std::set<std::string>{"ball", "moved", "out", "pair"});
  CHECK(cached(0.2) == std::set<std::string>{"ball", "pair"});
}

TEST_CASE("Different requests at once do not disturb one another") {
  const std::unique_ptr<Engine> engine_owner = example_engine();
  const Engine& engine = *engine_owner;
  const Json graph = small_graph();
  constexpr int callers = 8;
  std::vector<std::string> files(callers);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < callers; ++i) {
      threads.emplace_back([&, i] {
        const Result<Answered> answer =
            answered(engine, request_for(graph, {{"amount", 0.1 * static_cast<double>(i)}}));
        if (answer) files[i] = *answer->glb;
      });
    }
  }
  CHECK(std::set<std::string>(files.begin(), files.end()).size() == callers);
  for (std::size_t i = 0; i < callers; ++i) {
    CHECK(files[i] == file_of(*example_engine(), request_for(graph, {{"amount", 0.1 * static_cast<double>(i)}})));
  }
}
