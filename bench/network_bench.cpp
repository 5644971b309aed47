// Networks of weighted points, a hundred steps: the nearest six of each found anew at every step, or all of all.

#include <benchmark/benchmark.h>
#include <vector>

#include "geometry/network.h"

namespace dini {
namespace {

constexpr std::size_t rows = 101;

double uniform(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) * 0x1p-52 - 1;
}

void run(benchmark::State& state, NeighborSearch search, std::size_t neighbors) {
  const auto size = static_cast<std::size_t>(state.range(0));
  Column<Point> start(size);
  std::vector<double> weights(size);
  std::uint64_t random = 3;
  for (std::size_t i = 0; i < size; ++i) {
    start.set(i, {uniform(random), uniform(random), uniform(random)});
    weights[i] = 2 * uniform(random);
  }
  kernels::NetworkSettings settings;
  settings.strength = 0.02;
  settings.softening = 0.01;
  settings.rest = 0.05;
  settings.longest_step = 0.01;
  const Cancel cancel;
  for (auto _ : state) {
    benchmark::DoNotOptimize(evolve(start, weights, settings, search, NeighborTable(size, neighbors), rows, cancel));
  }
  state.counters["Mstep/s"] =
      benchmark::Counter(1e-6 * static_cast<double>(size * (rows - 1)) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

void nearest_six(benchmark::State& state) { run(state, NeighborSearch::nearest, 6); }
void all_of_all(benchmark::State& state) { run(state, NeighborSearch::all, 0); }
BENCHMARK(nearest_six)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(all_of_all)->Arg(1'000)->Arg(3'000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
