#include "geometry/surface.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "algebra/kernels.h"
#include "tests/geometry/grids.h"

using namespace dini;
using namespace dini::support;

namespace {

Grid torus_grid(std::size_t rows, std::size_t columns) {
  return Grid(rows, columns, true, true, [](double u, double v) { return torus_point(u, v); });
}

Grid sphere_grid(std::size_t rows, std::size_t columns) {
  return Grid(rows, columns, false, true, [](double u, double v) { return sphere_point(u, v); });
}

Grid plane_grid(std::size_t rows, std::size_t columns) {
  return Grid(rows, columns, false, false, [](double u, double v) { return Point{u, v, 0}; });
}

}  // namespace

TEST_CASE("A flat sheet looks along rows cross columns and spans the unit square of texture") {
  const Mesh mesh = surface_of(plane_grid(3, 5)).mesh;
  CHECK(mesh.positions.size() == 15);
  CHECK(mesh.triangles.size() == 16);
  CHECK(normals_match_faces(mesh));
  for (std::size_t i = 0; i < 15; ++i) {
    CHECK(length(mesh.normals[i] - Vector{0, 0, 1}) < 1e-14);
    CHECK(mesh.uvs[i] == std::array<double, 2>{mesh.positions[i].x, mesh.positions[i].y});
  }
  const Measures measures = measured(mesh);
  CHECK(measures.area == Approx(1).epsilon(1e-14));
  CHECK(measures.euler == 1);
  CHECK(measures.boundary_edges == 12);
}

TEST_CASE("A doubly closed grid is a watertight torus that shares its seams") {
  const auto rows = GENERATE(3, 4, 7, 40);
  const auto columns = GENERATE(3, 5, 32);
  const Mesh mesh = surface_of(torus_grid(rows, columns)).mesh;
  CHECK(mesh.positions.size() == static_cast<std::size_t>(rows * columns));
  CHECK(mesh.triangles.size() == static_cast<std::size_t>(2 * rows * columns));
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 0);
  CHECK(measures.boundary_edges == 0);
  CHECK(measures.volume > 0);
  CHECK(least_height(mesh) > 1e-3);
}

TEST_CASE("Rows that are one point become poles of a watertight sphere") {
  const auto rows = GENERATE(3, 4, 25);
  const auto columns = GENERATE(3, 4, 48);
  const Mesh mesh = surface_of(sphere_grid(rows, columns)).mesh;
  CHECK(mesh.positions.size() == static_cast<std::size_t>((rows - 2) * columns + 2));
  CHECK(mesh.triangles.size() == static_cast<std::size_t>(2 * (rows - 2) * columns));
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.volume > 0);
  CHECK(normals_match_faces(mesh));
  CHECK(least_height(mesh) > 1e-3);
}

TEST_CASE("Columns that are one point become poles as well") {
  const Grid grid(24, 13, true, false, [](double u, double v) { return sphere_point(v, -u); });
  const Measures measures = measured(surface_of(grid).mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.volume > 0);
}

TEST_CASE("Poles that coincide only up to round-off are poles") {
  const Grid grid(9, 16, false, true, [](double u, double v) {
    const Point p = sphere_point(u, v);
    return Point{p.x + 3e-16 * std::round(17 * v), p.y, p.z};
  });
  CHECK(measured(surface_of(grid).mesh).euler == 2);
}

TEST_CASE("A row inside a grid that is one point becomes the tip of a double cone") {
  const Grid grid(5, 12, false, true, [](double u, double v) {
    const SineCosine around = sine_cosine(v);
    return Point{(u - 0.5) * around.cosine, (u - 0.5) * around.sine, u};
  });
  const Mesh mesh = surface_of(grid).mesh;
  CHECK(mesh.positions.size() == 4 * 12 + 1);
  CHECK(mesh.triangles.size() == (2 + 1 + 1 + 2) * 12);
  CHECK(least_height(mesh) > 1e-3);
}

TEST_CASE("Normals of a sphere grid converge to the exact ones") {
  const double coarse = normal_error(surface_of(sphere_grid(25, 48)).mesh, sphere_normal);
  const double fine = normal_error(surface_of(sphere_grid(49, 96)).mesh, sphere_normal);
  CHECK(coarse < 1e-3);
  CHECK(fine < coarse / 7);
}

TEST_CASE("Normals of an uneven torus grid converge with the fourth order") {
  const auto error = [](std::size_t rows, std::size_t columns) {
    // Differences of an even grid would be exact by symmetry.
    const Grid grid(rows, columns, true, true, [](double u, double v) {
      return torus_point(u + 0.08 * sine_cosine(u + v).sine, v + 0.1 * sine_cosine(v).cosine);
    });
    return normal_error(surface_of(grid).mesh, [](const Point& p) { return torus_normal(p); });
  };
  const double coarse = error(64, 64), fine = error(128, 128);
  CHECK(coarse < 1e-3);
  CHECK(coarse / fine > 14);
}

TEST_CASE("Normals stay exact to a part in a thousand at open borders") {
  const Grid grid(20, 30, false, false, [](double u, double v) { return sphere_point(0.2 + 0.5 * u, 0.4 * v); });
  CHECK(normal_error(surface_of(grid).mesh, sphere_normal) < 1e-3);
}

TEST_CASE("Area and volume of a torus grid converge to the closed forms") {
  const double area = 4 * pi * pi * 2 * 0.5, volume = 2 * pi * pi * 2 * 0.25;
  const Measures coarse = measured(surface_of(torus_grid(64, 32)).mesh);
  const Measures fine = measured(surface_of(torus_grid(128, 64)).mesh);
  CHECK(fine.area == Approx(area).epsilon(2e-3));
  CHECK(fine.volume == Approx(volume).epsilon(4e-3));
  CHECK(std::abs(fine.area - area) < std::abs(coarse.area - area) / 3.5);
  CHECK(std::abs(fine.volume - volume) < std::abs(coarse.volume - volume) / 3.5);
}

TEST_CASE("Quads are split along one diagonal unless that folds them") {
  Column<Point> points(4);
  points.set(1, {0, 1, 0});
  points.set(2, {1, 0, 0});
  SECTION("a stretched corner") {
    points.set(3, {3, 3, 0});
    const Mesh mesh = surface({.points = points, .rows = 2, .columns = 2}, {}, never_stopped).mesh;
    CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 2, 3}, {0, 3, 1}});
    CHECK(measured(mesh).area == Approx(3));
  }
  SECTION("a corner pulled in past the shorter diagonal") {
    points.set(0, {0.9, 0.9, 0});
    points.set(3, {3, 3, 0});
    points.set(1, {0, 1, 0});
    const Mesh mesh = surface({.points = points, .rows = 2, .columns = 2}, {}, never_stopped).mesh;
    CHECK(normals_match_faces(mesh));
    CHECK(measured(mesh).area == Approx(2.1));
  }
}

TEST_CASE("Thinning keeps closed axes closed, ends in place and the budget") {
  const std::size_t budget = GENERATE(12u, 100u, 777u, 5000u);
  const Mesh torus = surface_of(torus_grid(101, 67), {.triangle_budget = budget}).mesh;
  CHECK(torus.triangles.size() <= std::max<std::size_t>(budget, 18));
  CHECK(torus.triangles.size() >= std::min<std::size_t>(budget, 18) / 2);
  CHECK(measured(torus).closed);
  CHECK(measured(torus).euler == 0);
  const Mesh sphere = surface_of(sphere_grid(101, 67), {.triangle_budget = budget}).mesh;
  CHECK(sphere.triangles.size() <= std::max<std::size_t>(budget, 6));
  if (budget >= 100) {
    CHECK(measured(sphere).euler == 2);
    CHECK(measured(sphere).minimum.z == -1);
    CHECK(measured(sphere).maximum.z == 1);
  }
}

TEST_CASE("Normals stay accurate on unevenly thinned grids") {
  const Mesh mesh = surface_of(torus_grid(150, 110), {.triangle_budget = 9000}).mesh;
  CHECK(mesh.triangles.size() > 8000);
  CHECK(normal_error(mesh, [](const Point& p) { return torus_normal(p); }) < 1e-3);
}

TEST_CASE("Tiles hold every triangle once and at most 128 x 128 quads") {
  const Mesh mesh = surface_of(plane_grid(300, 131)).mesh;
  CHECK(mesh.tile_ends.size() == 6);
  CHECK(mesh.tile_ends.back() == mesh.triangles.size());
  CHECK(mesh.triangles.size() == 2 * 299 * 130);
  CHECK(largest_tile(mesh) == 2 * 128 * 128);
}

TEST_CASE("A grid is read through its strides") {
  const Grid grid = plane_grid(4, 6);
  const Mesh mesh =
      surface({.points = grid.points, .rows = 6, .columns = 2, .offset = 6, .row_stride = 1, .column_stride = 6}, {},
              never_stopped)
          .mesh;
  CHECK(mesh.positions.size() == 12);
  CHECK(mesh.normals[0].z == Approx(-1));
  CHECK(measured(mesh).minimum.x == Approx(1.0 / 3));
  CHECK(measured(mesh).maximum.x == Approx(2.0 / 3));
}

TEST_CASE("Degenerate grids give empty meshes") {
  const auto empty = [](const Grid& grid) {
    const SurfaceResult result = surface_of(grid);
    return result.mesh.triangles.empty() && result.mesh.positions.empty() && result.mesh.tile_ends.empty();
  };
  const bool closed = GENERATE(false, true);
  CHECK(empty(Grid(6, 5, closed, closed, [](double, double) { return Point{1, 2, 3}; })));
  CHECK(empty(Grid(1, 5, closed, closed, [](double, double v) { return Point{v, 0, 0}; })));
  CHECK(empty(Grid(5, 1, closed, closed, [](double u, double) { return Point{u, 0, 0}; })));
  CHECK(empty(Grid(1, 1, closed, closed, [](double, double) { return Point{1, 0, 0}; })));
  CHECK(empty(Grid(0, 0, closed, closed, [](double, double) { return Point{}; })));
  CHECK(empty(Grid(5, 4, closed, closed, [](double u, double v) { return Point{u + v, u + v, 0}; })));
  CHECK(empty(Grid(5, 4, closed, closed, [](double, double) { return Point::at_infinity(); })));
  CHECK(empty(Grid(5, 4, closed, closed, [](double u, double v) { return Point{u + 1e9, v, 0}; })));
}

TEST_CASE("A closed axis of two samples is open") {
  const Grid grid(2, 8, true, false, [](double u, double v) { return Point{u, v, 0}; });
  CHECK(surface_of(grid).mesh.triangles.size() == 14);
}

TEST_CASE("A stopped request ends early") {
  Cancel cancel;
  cancel.stop(StopReason::client_gone);
  const Grid grid = torus_grid(300, 300);
  CHECK(surface(grid.view(), {}, cancel).mesh.triangles.size() <= 2 * 128 * 128);
}

TEST_CASE("The same grid gives the same mesh") {
  const Grid grid = sphere_grid(30, 30);
  const Mesh a = surface_of(grid).mesh, b = surface_of(grid).mesh;
  CHECK((a.positions == b.positions));
  CHECK((a.normals == b.normals));
  CHECK(a.triangles == b.triangles);
}

TEST_CASE("Tiles of one shape have the same triangles whatever the points are") {
  const bool closed = GENERATE(false, true);
  const auto bent = [&](double bend) {
    return surface_of(Grid(150, 140, closed, closed,
                           [&](double u, double v) {
                             const Point p = closed ? torus_point(u, v) : Point{u, 2 * v, 0};
                             const double wave = bend * sine_cosine(3 * u).sine * sine_cosine(2 * v).cosine;
                             return Point{p.x * (1 + wave), p.y, p.z + wave};
                           }))
        .mesh;
  };
  const Mesh plain = bent(0);
  for (const double bend : {0.02, 0.05, -0.1}) {
    const Mesh mesh = bent(bend);
    CHECK(mesh.triangles == plain.triangles);
    CHECK(mesh.tile_ends == plain.tile_ends);
  }
}

TEST_CASE("What is cut out of a surface changes nothing elsewhere") {
  Grid grid(160, 150, false, false, [](double u, double v) {
    return Point{2 * u, 2 * v, 0.2 * sine_cosine(u + 0.3 * v).sine * sine_cosine(v).cosine};
  });
  const Mesh whole = surface_of(grid).mesh;
  const std::size_t row = GENERATE(0u, 70u, 128u), column = GENERATE(149u, 127u, 3u);
  grid.points.set(row * grid.columns + column, Point::at_infinity());
  const SurfaceResult cut = surface_of(grid);
  CHECK(cut.first_clipped == std::array<std::size_t, 2>{row, column});
  const auto near = [&](const Point& p) {
    return std::abs(p.x - 2.0 * static_cast<double>(row) / 159) < 0.1 &&
           std::abs(p.y - 2.0 * static_cast<double>(column) / 149) < 0.1;
  };
  std::size_t compared = 0;
  for (std::size_t i = 0, k = 0; i < cut.mesh.positions.size() && k < whole.positions.size(); ++i, ++k) {
    while (k < whole.positions.size() && whole.positions[k] != cut.mesh.positions[i]) ++k;
    REQUIRE(k < whole.positions.size());
    if (near(whole.positions[k])) continue;
    CHECK(length(whole.normals[k] - cut.mesh.normals[i]) < 1e-14);
    CHECK(whole.uvs[k] == cut.mesh.uvs[i]);
    ++compared;
  }
  CHECK(compared > 23'000);
  CHECK(cut.mesh.triangles.size() >= whole.triangles.size() - 8);
}

TEST_CASE("Neither threads nor instruction sets change a surface") {
  const Grid grid = GENERATE(true, false) ? sphere_grid(200, 170) : Grid(190, 210, false, true, [](double u, double v) {
    return Point{u / (0.503 - v), v, sine_cosine(u * v).sine};
  });
  const auto made = [&](int threads) {
    tbb::task_arena arena(threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    return arena.execute([&] { return surface(grid.view(), {}, never_stopped); });
  };
  const SurfaceResult one = made(1);
  const auto same = [&](const SurfaceResult& other) {
    return other.mesh.positions == one.mesh.positions && other.mesh.normals == one.mesh.normals &&
           other.mesh.uvs == one.mesh.uvs && other.mesh.triangles == one.mesh.triangles &&
           other.clipped_quads == one.clipped_quads && other.first_clipped == one.first_clipped;
  };
  CHECK(!one.mesh.triangles.empty());
  for (const int threads : {2, 5, 8}) CHECK(same(made(threads)));
  for (const char* name : kernels::instruction_sets()) {
    REQUIRE(kernels::force_instruction_set(name));
    const SurfaceResult other = made(2);
    kernels::force_instruction_set("");
    INFO(name);
    CHECK(same(other));
  }
}

TEST_CASE("A copy of a mesh shares what it does not change") {
  const Mesh mesh = surface_of(torus_grid(20, 10)).mesh;
  Mesh copy = mesh;
  copy.color = {1, 0, 0, 1};
  CHECK(copy.positions.component(0) == mesh.positions.component(0));
  CHECK(copy.triangles.data() == mesh.triangles.data());
  const Point first = mesh.positions[0];
  copy.positions.set(0, {7, 8, 9});
  CHECK(copy.positions[0] == Point{7, 8, 9});
  CHECK(mesh.positions[0] == first);
  CHECK(copy.normals.component(0) == mesh.normals.component(0));
}
