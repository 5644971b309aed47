#include <bit>

#include "geometry/angle.h"
#include "geometry/decimate.h"
#include "geometry/merge.h"
#include "geometry/normals.h"
#include "geometry/primitives.h"
#include "geometry/sampling.h"
#include "geometry/weld.h"
#include "tests/geometry/grids.h"

using namespace dini;
using namespace dini::support;

namespace {

Mesh mesh_of(const std::vector<Point>& positions, const NumberList<std::array<std::uint32_t, 3>>& triangles) {
  Mesh mesh;
  mesh.positions = Column<Point>(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) mesh.positions.set(i, positions[i]);
  mesh.triangles = triangles;
  return mesh;
}

Mesh tetrahedron() {
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

/// Every triangle with three vertices of its own.
Mesh torn_apart(const Mesh& mesh) {
  std::vector<Point> positions;
  NumberList<std::array<std::uint32_t, 3>> triangles;
  for (const auto& triangle : mesh.triangles) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    for (const std::uint32_t corner : triangle) positions.push_back(mesh.positions[corner]);
    triangles.push_back({base, base + 1, base + 2});
  }
  return mesh_of(positions, triangles);
}

}  // namespace

TEST_CASE("Sines and cosines match the library and are exact at quarter turns") {
  for (int i = -400; i <= 400; ++i) {
    const double turns = i / 97.0;
    const SineCosine result = sine_cosine(turns);
    CHECK(result.sine == Approx(std::sin(2 * pi * turns)).margin(1e-14));
    CHECK(result.cosine == Approx(std::cos(2 * pi * turns)).margin(1e-14));
    CHECK(std::abs(result.sine * result.sine + result.cosine * result.cosine - 1) < 4e-16);
  }
  for (const double turns : {0.0, 1.0, -3.0, 7e14}) CHECK(sine_cosine(turns).cosine == 1);
  for (const double turns : {0.25, 1.25, -0.75}) CHECK(sine_cosine(turns).sine == 1);
  for (const double turns : {0.5, -0.5}) CHECK(sine_cosine(turns).sine == 0);
}

TEST_CASE("Angles match the library") {
  for (int i = 0; i <= 1000; ++i) {
    const double angle = pi * i / 1000;
    CHECK(std::abs(angle_of(std::cos(angle), std::abs(std::sin(angle))) - angle) < 1e-15);
  }
  CHECK(angle_of(0, 0) == 0);
  CHECK(angle_of(-2, 0) == pi);
  CHECK(angle_between({1e200, 0, 0}, {0, 1e-200, 0}) == Approx(pi / 2));
  CHECK(angle_between({1, 0, 0}, {1, 1e-9, 0}) == Approx(1e-9));
}

TEST_CASE("Spaced samples hit both ends exactly and leave the end of closed ranges out") {
  const Column<double> open = spaced(0.1, 0.7, 7, false, never_stopped);
  CHECK(open[0] == 0.1);
  CHECK(open[6] == 0.7);
  CHECK(open[3] == Approx(0.4));
  const Column<double> closed = spaced(0, 1, 3, true, never_stopped);
  CHECK(closed[1] == 1.0 / 3);
  CHECK(closed[2] == 2.0 / 3);
  const Column<double> whole = spaced(-5, 5, 11, false, never_stopped);
  for (std::size_t i = 0; i < 11; ++i) CHECK(whole[i] == static_cast<double>(i) - 5);
  CHECK(spaced(3, 4, 1, false, never_stopped)[0] == 3);
  CHECK(spaced(3, 4, 1, true, never_stopped)[0] == 3);
  CHECK(spaced(3, 4, 0, false, never_stopped).empty());
  CHECK(spaced(3, 4, 0, true, never_stopped).empty());
  const Column<double> same = spaced(0.1, 0.1, 50, false, never_stopped);
  const Column<double> huge = spaced(-1.7e308, 1.7e308, 50, false, never_stopped);
  for (std::size_t i = 0; i < 50; ++i) {
    CHECK(same[i] == 0.1);
    CHECK(std::isfinite(huge[i]));
  }
}

TEST_CASE("Positions get the label of the first equal one") {
  const Mesh mesh = mesh_of({{0, 0, 1}, {1, 0, 0}, {-0.0, 0, 1}, {1, 0, 0}, {1, 0, 1e-300}}, {});
  CHECK(position_labels(mesh.positions, Cancel()) == std::vector<std::uint32_t>{0, 1, 0, 1, 4});
  CHECK(position_labels({}, Cancel()).empty());
}

TEST_CASE("Positions that were made to fall into one place of a plain table are welded as quickly as others") {
  // Undoes the mixing of the table, for a table without a seed: x for which the hash is `target` where y = z = 0.
  const auto x_with_hash = [](std::uint64_t target) {
    std::uint64_t inverse = 1;
    for (int i = 0; i < 6; ++i) inverse *= 2 - 0xd6e8feb86659fd93u * inverse;
    std::uint64_t bits = target;
    for (int i = 0; i < 2; ++i) bits = (bits ^ bits >> 32) * inverse;
    return std::bit_cast<double>(bits ^ bits >> 32);
  };
  Column<Point> positions(200'000);
  std::uint64_t wanted = 0;
  for (std::size_t i = 0; i < positions.size(); ++wanted) {
    const double x = x_with_hash(wanted << 32);
    if (std::abs(x) < 1e18 && std::abs(x) > 1e-300) positions.set(i++, {x, 0, 0});
  }
  const std::vector<std::uint32_t> labels = position_labels(positions, Cancel());
  for (std::uint32_t i = 0; i < labels.size(); ++i) REQUIRE(labels[i] == i);
}

TEST_CASE("A tetrahedron measures right, whole or torn apart") {
  const Mesh mesh = GENERATE(tetrahedron(), torn_apart(tetrahedron()));
  const Measures measures = measured(mesh);
  CHECK(measures.volume == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(measures.area == Approx(1.5 + std::sqrt(3) / 2).epsilon(1e-14));
  CHECK(measures.vertices == 4);
  CHECK(measures.edges == 6);
  CHECK(measures.triangles == 4);
  CHECK(measures.euler == 2);
  CHECK(measures.boundary_edges == 0);
  CHECK(measures.closed);
  CHECK(measures.minimum == Point{0, 0, 0});
  CHECK(measures.maximum == Point{1, 1, 1});
  CHECK(measures.diagonal == Approx(std::sqrt(3)));
}

TEST_CASE("Open, flipped and crowded edges are not closed") {
  Mesh open = tetrahedron();
  open.triangles.edit().pop_back();
  CHECK(!measured(open).closed);
  CHECK(measured(open).boundary_edges == 3);
  Mesh flipped = tetrahedron();
  std::swap(flipped.triangles.edit()[0][0], flipped.triangles.edit()[0][1]);
  CHECK(!measured(flipped).closed);
  CHECK(measured(flipped).boundary_edges == 0);
  const Mesh book =
      mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  CHECK(measured(book).edges == 7);
  CHECK(measured(book).boundary_edges == 6);
  CHECK(!measured(book).closed);
}

TEST_CASE("Nothing measures nothing, and vertices of no triangle do not count") {
  const Measures nothing = measured({});
  CHECK(nothing.area == 0);
  CHECK(nothing.diagonal == 0);
  CHECK(nothing.minimum == Point{});
  CHECK(!nothing.closed);
  const Mesh mesh = mesh_of({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 2, 3}});
  CHECK(measured(mesh).maximum == Point{1, 1, 0});
  CHECK(measured(mesh).vertices == 3);
}

TEST_CASE("Areas and volumes do not drift with the number of triangles or the place") {
  const Grid grid(500, 500, false, false, [](double u, double v) { return Point{u, v, 1e6}; });
  CHECK(std::abs(measured(surface_of(grid, {.clip_radius = 1e7}).mesh).area - 1) < 1e-12);
  const Measures here = measured(torus_mesh({}, {0, 0, 1}, 2, 0.5, 400, 200, never_stopped));
  const Measures far = measured(torus_mesh({1e4, 0, 0}, {0, 0, 1}, 2, 0.5, 400, 200, never_stopped));
  CHECK(std::abs(far.volume / here.volume - 1) < 1e-10);
  CHECK(std::abs(far.area / here.area - 1) < 1e-10);
}

TEST_CASE("Smooth normals point outward and converge on a sphere") {
  const Mesh coarse = sphere_mesh({}, 1, 48, 24, never_stopped);
  const Mesh fine = torn_apart(sphere_mesh({}, 1, 192, 96, never_stopped));
  const auto error = [](Mesh mesh) {
    mesh.normals = smooth_normals(mesh, never_stopped);
    CHECK(!mesh_defect(mesh));
    return normal_error(mesh, sphere_normal);
  };
  CHECK(error(coarse) < 1e-2);
  CHECK(error(fine) < 1e-3);
}

TEST_CASE("Smooth normals weigh by angle, so that a cube's corner is on its diagonal however its faces are cut") {
  const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                            {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {0, 4, 3}, {3, 4, 6}});
  const Vector corner = smooth_normals(mesh, never_stopped)[0];
  CHECK(length(corner - normalized(Vector{-1, -1, -1})) < 1e-14);
}

TEST_CASE("Smooth normals fall back to e3") {
  const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {2, 0, 0}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 4}});
  const Column<Vector> normals = smooth_normals(mesh, never_stopped);
  for (std::size_t i = 0; i < 5; ++i) CHECK(normals[i] == Vector{0, 0, 1});
}

TEST_CASE("Merging keeps every attribute that any mesh has") {
  auto bare = std::make_shared<Mesh>(tetrahedron());
  bare->color = {1, 0, 0, 1};
  auto full = std::make_shared<Mesh>(sphere_mesh({5, 0, 0}, 1, 8, 4, never_stopped));
  full->color = bare->color;
  SECTION("normals, texture coordinates, tiles") {
    const Mesh merged = merge(std::vector<SharedMesh>{bare, nullptr, full, bare}, never_stopped);
    CHECK(!mesh_defect(merged));
    CHECK(merged.triangles.size() == 4 + full->triangles.size() + 4);
    CHECK(merged.normals.size() == merged.positions.size());
    CHECK(merged.normals[4] == full->normals[0]);
    CHECK(merged.uvs[0] == std::array<double, 2>{0, 0});
    CHECK(merged.uvs[7] == full->uvs[3]);
    CHECK(merged.colors.empty());
    CHECK(merged.color == bare->color);
    CHECK(merged.tile_ends.size() == 3);
    CHECK(measured(merged).volume == Approx(measured(*full).volume + 1.0 / 6 + 1.0 / 6));
  }
  SECTION("meshes of different colors get vertex colors") {
    full->color = {0, 1, 0, 0.5};
    const Mesh merged = merge(std::vector<SharedMesh>{bare, full}, never_stopped);
    REQUIRE(merged.colors.size() == merged.positions.size());
    CHECK(merged.colors[3] == std::array<float, 4>{1, 0, 0, 1});
    CHECK(merged.colors[4] == std::array<float, 4>{0, 1, 0, 0.5f});
  }
  SECTION("nothing") {
    CHECK(merge({}, never_stopped).positions.empty());
    CHECK(merge(std::vector<SharedMesh>{nullptr}, never_stopped).positions.empty());
  }
}

TEST_CASE("Every broken invariant of a mesh is named") {
  const auto defect = [](auto breaking) {
    Mesh mesh = sphere_mesh({}, 1, 8, 4, never_stopped);
    breaking(mesh);
    return mesh_defect(mesh).value_or("none");
  };
  CHECK(defect([](Mesh&) {}) == "none");
  CHECK(defect([](Mesh& mesh) { mesh.normals = Column<Vector>(3); }) == "3 normals for 26 vertices");
  CHECK(defect([](Mesh& mesh) { mesh.uvs.edit().pop_back(); }) == "25 uvs for 26 vertices");
  CHECK(defect([](Mesh& mesh) { mesh.colors.resize(1); }) == "1 colors for 26 vertices");
  CHECK(defect([](Mesh& mesh) { mesh.triangles.edit()[5][1] = 26; }) == "triangle 5 uses a vertex that is not there");
  CHECK(defect([](Mesh& mesh) { mesh.triangles.edit()[5][1] = mesh.triangles[5][0]; }) ==
        "triangle 5 uses a vertex twice");
  CHECK(defect([](Mesh& mesh) { mesh.positions.set(2, Point::at_infinity()); }) ==
        "position 2 is not finite or too large");
  CHECK(defect([](Mesh& mesh) { mesh.positions.set(2, {0, 1e18, 0}); }) == "position 2 is not finite or too large");
  CHECK(defect([](Mesh& mesh) { mesh.normals.set(1, {0, 0, 0.9}); }) == "normal 1 is not of unit length");
  CHECK(defect([](Mesh& mesh) { mesh.uvs.edit()[4][1] = NAN; }) == "uv 4 is not finite");
  CHECK(defect([](Mesh& mesh) { mesh.colors.edit().resize(26, {0, 0, 2, 1}); }) == "color 0 is outside [0, 1]");
  CHECK(defect([](Mesh& mesh) { mesh.tile_ends.edit() = {4, 4, 48}; }) == "tile 1 is empty or out of order");
  CHECK(defect([](Mesh& mesh) { mesh.tile_ends.edit() = {4}; }) == "the last tile does not end at the last triangle");
}

TEST_CASE("A decimated mesh keeps to its number and its shape") {
  const Mesh fine = sphere_mesh({1, 2, 3}, 2, 200, 100, never_stopped);
  for (const std::size_t most : {12, 100, 1000, 10'000}) {
    CAPTURE(most);
    const Mesh coarse = decimate(fine, most, never_stopped);
    CHECK(mesh_defect(coarse) == std::nullopt);
    CHECK(coarse.triangles.size() <= most);
    CHECK(coarse.triangles.size() > most / 4);
    CHECK(coarse.normals.size() == coarse.positions.size());
    CHECK(coarse.uvs.size() == coarse.positions.size());
    for (std::size_t i = 0; i < coarse.positions.size(); ++i) {
      CHECK(length(to_vector(coarse.positions[i]) - Vector{1, 2, 3}) == Approx(2));
    }
    if (most < 1000) continue;
    CHECK(measured(coarse).area == Approx(measured(fine).area).epsilon(0.1));
  }
}

TEST_CASE("A mesh that is coarse enough stays, and something is left of any with area") {
  const Mesh mesh = sphere_mesh({}, 1, 8, 4, never_stopped);
  CHECK(decimate(mesh, mesh.triangles.size(), never_stopped).triangles == mesh.triangles);
  CHECK_FALSE(decimate(mesh, 1, never_stopped).triangles.empty());
  CHECK(decimate(Mesh{}, 1, never_stopped).triangles.empty());
  Mesh point = mesh;
  point.positions = Column<Point>(mesh.positions.size());
  CHECK(decimate(point, 1, never_stopped).triangles.empty());
}
