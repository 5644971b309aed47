// Cutting a surface of a million triangles into tiles that can be compressed: renumbered, checked and rounded to
// floats.

#include <benchmark/benchmark.h>
#include <cmath>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <vector>

#include "geometry/surface.h"
#include "gltf/tiles.h"

namespace dini {
namespace {

constexpr std::size_t side = 708;

Mesh million_triangles() {
  Column<Point> points(side * side);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = 2 * static_cast<double>(i / side) / (side - 1), y = 2 * static_cast<double>(i % side) / (side - 1);
    points.set(i, {x, y, 0.1 * std::sin(3 * x) * std::cos(4 * y)});
  }
  return surface({.points = points, .rows = side, .columns = side}, {}, Cancel()).mesh;
}

void build_tiles(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(0));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  const Mesh mesh = million_triangles();
  const EncodeOptions options;
  const std::vector<std::size_t> ends = plan_tiles(mesh, tile_sizes(options));
  std::vector<Tile> tiles(ends.size());
  for (auto _ : state) {
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t i) {
        tiles[i] = *build_tile(mesh, i == 0 ? 0 : ends[i - 1], ends[i], options, Cancel());
      });
    });
  }
  state.counters["tiles"] = static_cast<double>(tiles.size());
}

BENCHMARK(build_tiles)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
