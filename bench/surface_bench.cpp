// Making the surface of a million triangles: a grid of 708 x 708 points that 16 pairs have warped, with normals and
// texture coordinates. Each row adds what makes a surface dearer than the plain one.

#include <benchmark/benchmark.h>
#include <cmath>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <vector>

#include "algebra/construct.h"
#include "algebra/kernels.h"
#include "geometry/surface.h"

namespace dini {
namespace {

constexpr std::size_t side = 708;
constexpr std::size_t pairs = 16;

double uniform(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) * 0x1p-52 - 1;
}

/// A square of 2 m, warped by pairs above and below it, then scaled.
Column<Point> warped_grid(double scale) {
  std::vector<kernels::WarpSource> sources;
  std::uint64_t state = 3;
  for (std::size_t i = 0; i < pairs; ++i) {
    const Point center{uniform(state), uniform(state), 0.6 + 0.4 * uniform(state)};
    sources.push_back(
        {null_pair(center, {0.05 * uniform(state), 0.05 * uniform(state), 0.05 * uniform(state)}), center});
  }
  Column<Point> flat(side * side), warped(side * side);
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto along = [](std::size_t at) { return 2 * static_cast<double>(at) / (side - 1) - 1; };
    flat.set(i, {along(i / side), along(i % side), 0});
  }
  kernels::warp_points(kernels::WarpField(sources), {1, 2, 0, Rule::exact, kernels::WarpMethod::sum_generators},
                       {flat.component(0), flat.component(1), flat.component(2)},
                       {warped.component(0), warped.component(1), warped.component(2)}, side * side);
  for (std::size_t i = 0; i < side * side; ++i) warped.set(i, to_point(scale * to_vector(warped[i])));
  return warped;
}

void run(benchmark::State& state, const PointGrid& grid, const SurfaceOptions& options) {
  const auto threads = static_cast<std::size_t>(state.range(0));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  for (auto _ : state) {
    const SurfaceResult result = arena.execute([&] { return surface(grid, options, Cancel()); });
    if (result.mesh.triangles.empty()) return state.SkipWithError("there is no surface");
    state.counters["triangles"] = static_cast<double>(result.mesh.triangles.size());
    state.counters["clipped"] = static_cast<double>(result.clipped_quads);
  }
}

/// Small beside the clip radius, as nearly all surfaces are.
void plain(benchmark::State& state) {
  const Column<Point> points = warped_grid(1);
  run(state, {.points = points, .rows = side, .columns = side}, {});
}

/// So large that a step of the grid could hold infinity.
void perhaps_torn(benchmark::State& state) {
  const Column<Point> points = warped_grid(100);
  run(state, {.points = points, .rows = side, .columns = side}, {});
}

/// Cut by the clip sphere all around.
void clipped(benchmark::State& state) {
  const Column<Point> points = warped_grid(1);
  run(state, {.points = points, .rows = side, .columns = side}, {.clip_radius = 1});
}

/// Thinned to a quarter of the triangles.
void thinned(benchmark::State& state) {
  const Column<Point> points = warped_grid(1);
  run(state, {.points = points, .rows = side, .columns = side}, {.triangle_budget = 250'000});
}

/// Read against the order of the points.
void transposed(benchmark::State& state) {
  const Column<Point> points = warped_grid(1);
  run(state, {.points = points, .rows = side, .columns = side, .row_stride = 1, .column_stride = side}, {});
}

/// A sphere: welded along one axis, with poles at the ends of the other.
void with_poles(benchmark::State& state) {
  Column<Point> points(side * side);
  const double turn = 8 * std::atan(1.0);
  for (std::size_t i = 0; i < side * side; ++i) {
    const double polar = turn / 2 * static_cast<double>(i / side) / (side - 1);
    const double around = turn * static_cast<double>(i % side) / side;
    points.set(i, {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)});
  }
  run(state, {.points = points, .rows = side, .columns = side, .closed_columns = true}, {});
}

/// 50,000 triangles.
void small(benchmark::State& state) {
  const Column<Point> points = warped_grid(1);
  run(state, {.points = points, .rows = 159, .columns = 159, .row_stride = 4 * side, .column_stride = 4}, {});
}

void arguments(benchmark::internal::Benchmark* bench) {
  bench->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(plain)->Apply(arguments);
BENCHMARK(perhaps_torn)->Apply(arguments);
BENCHMARK(clipped)->Apply(arguments);
BENCHMARK(thinned)->Apply(arguments);
BENCHMARK(transposed)->Apply(arguments);
BENCHMARK(with_poles)->Apply(arguments);
BENCHMARK(small)->Apply(arguments);

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
