// What stands between the body of a request and its plan, for a graph of 1,000 nodes: by how much it is known already.

#include <benchmark/benchmark.h>
#include <string>

#include "graph/digest.h"
#include "service/identity.h"
#include "service/requests/requests.h"

namespace dini {
namespace {

constexpr int node_count = 1000;

/// A chain of boosted circles, with one parameter at its beginning.
Json document() {
  Json nodes = {{"n0", {{"type", "circle"}, {"inputs", {{"radius", {{"parameter", "reach"}}}}}}}};
  for (int i = 1; i < node_count - 1; ++i) {
    nodes["n" + std::to_string(i)] = {
        {"type", "translate"},
        {"inputs", {{"shape", {{"from", "n" + std::to_string(i - 1)}}}, {"vector", {0.125, 0.25 * i, 0.001}}}}};
  }
  nodes["out"] = {{"type", "export"}, {"inputs", {{"model", {{"from", "n" + std::to_string(node_count - 2)}}}}}};
  return {{"format", 1},
          {"parameters", {{"reach", {{"type", "number"}, {"default", 1}, {"min", 0.1}, {"max", 4}}}}},
          {"nodes", nodes}};
}

std::string body(double reach) { return Json{{"graph", document()}, {"parameters", {{"reach", reach}}}}.dump(); }

EvaluateRequest read(const Engine& engine, const std::string& text) {
  return *read_evaluate_body(*parse_json(text, engine.limits()), engine);
}

void hash_of_body(benchmark::State& state) {
  const std::string text = body(2);
  for (auto _ : state) benchmark::DoNotOptimize(sha256(text));
}
BENCHMARK(hash_of_body)->Unit(benchmark::kMicrosecond);

void json_of_body(benchmark::State& state) {
  const std::string text = body(2);
  for (auto _ : state) benchmark::DoNotOptimize(parse_json(text, Limits{}));
}
BENCHMARK(json_of_body)->Unit(benchmark::kMicrosecond);

void hash_of_graph(benchmark::State& state) {
  const Json json = document();
  for (auto _ : state) benchmark::DoNotOptimize(graph_hash(json));
}
BENCHMARK(hash_of_graph)->Unit(benchmark::kMicrosecond);

void unknown_graph(benchmark::State& state) {
  const auto engine = make_engine();
  const std::string text = body(2);
  for (auto _ : state) {
    engine->forget();
    const EvaluateRequest request = read(*engine, text);
    benchmark::DoNotOptimize(engine->prepare(request, Cancel()));
  }
}
BENCHMARK(unknown_graph)->Unit(benchmark::kMicrosecond);

void known_graph_new_parameter(benchmark::State& state) {
  const auto engine = make_engine();
  const std::string text = body(2);
  for (auto _ : state) {
    const EvaluateRequest request = read(*engine, text);
    benchmark::DoNotOptimize(engine->prepare(request, Cancel()));
  }
}
BENCHMARK(known_graph_new_parameter)->Unit(benchmark::kMicrosecond);

void known_request_new_bytes(benchmark::State& state) {
  const auto engine = make_engine();
  const std::string text = body(2);
  for (auto _ : state) benchmark::DoNotOptimize(identity_of(read(*engine, text)));
}
BENCHMARK(known_request_new_bytes)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
