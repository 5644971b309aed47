// Meshing implicit solids: six boosted primitives, blended, in grids of 64, 128 and 256 cells, on one thread and two;
// and the same solid under a warp by four pairs.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "algebra/construct.h"
#include "algebra/versor.h"
#include "geometry/field_blend.h"
#include "geometry/field_motion.h"
#include "geometry/field_shapes.h"
#include "geometry/field_warp.h"
#include "geometry/implicit_mesh.h"

namespace dini {
namespace {

SharedField boosted(const SharedField& shape, const Point& position, const Vector& tangent) {
  return moved_field(shape, exponential(null_pair(position, tangent))).value();
}

SharedField six_boosted(double blend) {
  std::vector<SharedField> fields;
  for (int k = 0; k < 6; ++k) {
    const double side = k % 2 == 0 ? 1 : -1, level = 0.3 * (k - 2.5);
    const Vector center{0.45 * side, 0.3 * level, level};
    const SharedField shape = k % 3 == 0 ? ring_field(center, {0, 0, 1}, 0.35, 0.12) : sphere_field(center, 0.32);
    fields.push_back(boosted(shape, {side, 1, level}, {0.1, -0.2 * side, 0.15}));
  }
  return union_field(std::move(fields), blend);
}

SharedField warped(const SharedField& shape) {
  std::vector<kernels::WarpSource> sources;
  for (const Point& place : {Point{1, 1, 1}, Point{-1, 1, -1}, Point{1, -1, -1}, Point{-1, -1, 1}}) {
    sources.push_back({null_pair(place, {0.05, 0.1, -0.05}), place});
  }
  return warped_field(shape, std::move(sources), 1, 3, 0.2);
}

void run(benchmark::State& state, const SharedField& field) {
  const auto resolution = static_cast<std::size_t>(state.range(0)), threads = static_cast<std::size_t>(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  const ImplicitOptions options{{-1.4, -1.4, -1.4}, {1.4, 1.4, 1.4}, resolution, 10'000'000, 100'000'000};
  for (auto _ : state) {
    const ImplicitSurface surface = arena.execute([&] { return implicit_mesh(field, options, Cancel()); });
    if (surface.mesh.triangles.empty()) return state.SkipWithError("there is no surface");
    state.counters["triangles"] = static_cast<double>(surface.mesh.triangles.size());
  }
}

void sharp(benchmark::State& state) { run(state, six_boosted(0)); }
void blended(benchmark::State& state) { run(state, six_boosted(0.1)); }
void under_warp(benchmark::State& state) { run(state, warped(six_boosted(0.1))); }

void sizes(benchmark::internal::Benchmark* row) {
  row->ArgNames({"cells", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int cells : {64, 128, 256}) {
    for (const int threads : {1, 2}) row->Args({cells, threads});
  }
}
BENCHMARK(sharp)->Apply(sizes);
BENCHMARK(blended)->Apply(sizes);
BENCHMARK(under_warp)->Apply(sizes);

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
