// Walls along a wavy surface: finding what there is to move, the wall itself, and looking for contacts of it.

#include <benchmark/benchmark.h>
#include <cmath>

#include "geometry/thicken.h"

namespace dini {
namespace {

/// A sheet of 2 x 2 meters with waves of 0.1 meters, of side * side vertices.
Mesh waves(std::size_t side) {
  Mesh mesh;
  Column<Point> positions(side * side);
  const double step = 2.0 / static_cast<double>(side - 1);
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const double x = step * static_cast<double>(column) - 1, y = step * static_cast<double>(row) - 1;
      positions.set(row * side + column, {x, y, 0.1 * std::sin(5 * x) * std::cos(4 * y)});
    }
  }
  mesh.positions = std::move(positions);
  for (std::size_t row = 0; row + 1 < side; ++row) {
    for (std::size_t column = 0; column + 1 < side; ++column) {
      const auto a = static_cast<std::uint32_t>(row * side + column), b = a + 1;
      const auto c = static_cast<std::uint32_t>(a + side), d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  mesh.tile_ends.push_back(mesh.triangles.size());
  return mesh;
}

void thicken(benchmark::State& state) {
  const Mesh mesh = waves(static_cast<std::size_t>(state.range(0)));
  const Cancel cancel;
  for (auto _ : state) {
    const WallSurface surface = wall_surface(mesh, cancel);
    if (surface.fault) return state.SkipWithError(surface.fault->c_str());
    const Mesh wall = wall_along(surface, {0, 0.02, {}}, cancel);
    if (contact_of(surface, {0, 0.02, {}}, cancel)) return state.SkipWithError("the wall meets itself");
    state.counters["triangles"] = static_cast<double>(wall.triangles.size());
  }
}
BENCHMARK(thicken)->ArgName("side")->Unit(benchmark::kMillisecond)->UseRealTime()->Arg(50)->Arg(158)->Arg(500);

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();
