// What derivatives cost: those of a surface by eight parameters, all as one family, beside one evaluation of the same
// graph into a file.

#include <benchmark/benchmark.h>

#include "service/value_source.h"

namespace dini {
namespace {

constexpr int pair_count = 4;

Json parameter(const std::string& name) { return {{"parameter", name}}; }

/// A square that four point pairs warp, each with a strength and a height of its own.
Json document(std::int64_t count) {
  Json nodes = {{"sheet", {{"type", "grid"}, {"inputs", {{"count_u", count}, {"count_v", count}}}}},
                {"skin", {{"type", "surface"}, {"inputs", {{"shape", {{"from", "bent3"}}}}}}},
                {"out", {{"type", "export"}, {"inputs", {{"model", {{"from", "skin"}}}}}}}};
  Json parameters = Json::object();
  for (int k = 0; k < pair_count; ++k) {
    const std::string number = std::to_string(k);
    const std::string before = k == 0 ? "sheet.points" : "bent" + std::to_string(k - 1);
    nodes["place" + number] = {{"type", "vector"},
                               {"inputs", {{"x", 0.3 * k - 0.5}, {"z", parameter("height" + number)}}}};
    nodes["pair" + number] = {{"type", "point_pair"}, {"inputs", {{"direction", {0, 0, 1}}}}};
    nodes["placed" + number] = {
        {"type", "translate"},
        {"inputs", {{"shape", {{"from", "pair" + number}}}, {"vector", {{"from", "place" + number}}}}}};
    nodes["bent" + number] = {{"type", "warp"},
                              {"inputs",
                               {{"shape", {{"from", before}}},
                                {"generators", {{"from", "placed" + number}}},
                                {"softening", 0.5},
                                {"strength", parameter("strength" + number)}}}};
    parameters["strength" + number] = {{"type", "number"}, {"default", 0.2}, {"min", -1}, {"max", 1}};
    parameters["height" + number] = {{"type", "number"}, {"default", 0.4}, {"min", 0.1}, {"max", 1}};
  }
  return {{"format", 1}, {"parameters", parameters}, {"nodes", nodes}};
}

/// Values that were never asked for.
Json next_setting(int& asked) {
  Json setting = Json::object();
  ++asked;
  for (int k = 0; k < pair_count; ++k) {
    setting["strength" + std::to_string(k)] = 0.2 + 1e-5 * asked;
    setting["height" + std::to_string(k)] = 0.4 + 1e-5 * asked;
  }
  return setting;
}

void one_evaluation(benchmark::State& state) {
  const auto engine = make_engine();
  const SharedGraph graph = engine->read(document(state.range(0)));
  int asked = 0;
  for (auto _ : state) {
    const auto prepared = engine->prepare({.graph = graph, .parameters = next_setting(asked)}, Cancel());
    benchmark::DoNotOptimize(engine->compute(**prepared, Job()));
  }
}
BENCHMARK(one_evaluation)->Arg(32)->Arg(128)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The value itself is known, as it is to who goes downhill.
void eight_derivatives(benchmark::State& state) {
  const auto engine = make_engine();
  const SharedGraph graph = engine->read(document(state.range(0)));
  const ValueSource& source = *engine->value_source();
  int asked = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const Json here = next_setting(asked);
    const ValuesRequest request{.graph = graph, .parameters = here, .places = {"skin"}};
    std::vector<Json> settings = {Json::object()};
    benchmark::DoNotOptimize(source.values(request, settings, Cancel()));
    settings.clear();
    for (const auto& [name, value] : here.items()) settings.push_back({{name, value.get<double>() + 1e-6}});
    state.ResumeTiming();
    benchmark::DoNotOptimize(source.values(request, settings, Cancel()));
  }
}
BENCHMARK(eight_derivatives)->Arg(32)->Arg(128)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
