#include "geometry/solid.h"

#include "geometry/box.h"
#include "geometry/cap.h"
#include "geometry/contacts.h"
#include "geometry/merge.h"
#include "geometry/primitives.h"
#include "geometry/thicken.h"
#include "tests/geometry/grids.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

WeldedMesh bare(const Mesh& mesh) { return welded(mesh, never_stopped); }

/// A part of the unit sphere, from one latitude to another, in turns from the upper pole; with outward faces.
Mesh zone(double from, double to, std::size_t rows, std::size_t columns) {
  const Grid grid(rows, columns, false, true, [&](double u, double v) {
    const SineCosine polar = sine_cosine(from + (to - from) * u), around = sine_cosine(v);
    return Point{polar.sine * around.cosine, polar.sine * around.sine, polar.cosine};
  });
  return surface_of(grid).mesh;
}

CappedMesh closed(const Mesh& mesh, CapKind kind, std::size_t rings = 8) {
  CappedMesh result = capped(mesh, {kind, rings, 100'000}, never_stopped);
  INFO(result.fault.value_or("no fault") << mesh_defect(result.mesh).value_or(""));
  CHECK_FALSE(result.fault);
  CHECK_FALSE(mesh_defect(result.mesh));
  return result;
}

/// A flat ring-shaped letter C, open at one side: not seen whole from its middle.
Mesh bent_prism() {
  const std::vector<std::array<double, 2>> outline = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}};
  const Grid grid(2, outline.size(), false, true, [&](double u, double v) {
    const auto& [x, y] = outline[static_cast<std::size_t>(v * static_cast<double>(outline.size()) + 0.5)];
    return Point{x, y, u};
  });
  return surface_of(grid).mesh;
}

}  // namespace

TEST_CASE("Borders and pieces are counted, and only closed surfaces are watertight") {
  const auto sound = [](const Mesh& mesh) { return soundness_of(bare(mesh), never_stopped); };
  const Mesh ball = sphere_mesh({0, 0, 0}, 1, 12, 8, never_stopped), pipe = zone(0.1, 0.3, 5, 12);
  CHECK(sound(ball).watertight);
  CHECK(sound(ball).borders == 0);
  CHECK(sound(ball).components == 1);
  CHECK_FALSE(sound(pipe).watertight);
  CHECK(sound(pipe).borders == 2);
  const std::vector<SharedMesh> parts = {
      std::make_shared<const Mesh>(sphere_mesh({9, 0, 0}, 1, 12, 8, never_stopped)), std::make_shared<const Mesh>(pipe),
      std::make_shared<const Mesh>(box_mesh({5, 0, 0}, {1, 1, 1}, 2, never_stopped))};
  const Soundness all = sound(merge(parts, never_stopped));
  CHECK_FALSE(all.watertight);
  CHECK(all.borders == 2);
  CHECK(all.components == 3);
  CHECK_FALSE(sound(Mesh{}).watertight);
  CHECK(sound(Mesh{}).components == 0);
}

TEST_CASE("Center and inertia of boxes are those of the formula, wherever they stand") {
  RandomElements random(4);
  for (int round = 0; round < 20; ++round) {
    const Vector size{1.5 + random.number(), 1.5 + random.number(), 1.5 + random.number()}, at = random.vector(50);
    const Mesh box = box_mesh(to_point(at), size, 2, never_stopped);
    const MassProperties mass = mass_properties(bare(box), never_stopped);
    const double volume = size.x * size.y * size.z;
    const Vector squares{size.x * size.x, size.y * size.y, size.z * size.z};
    CHECK(length(mass.center - at) < 1e-11);
    CHECK(mass.inertia.x == Approx(volume / 12 * (squares.y + squares.z)).epsilon(1e-11));
    CHECK(mass.inertia.y == Approx(volume / 12 * (squares.z + squares.x)).epsilon(1e-11));
    CHECK(mass.inertia.z == Approx(volume / 12 * (squares.x + squares.y)).epsilon(1e-11));
    CHECK(length(mass.products) < 1e-10);
  }
}

TEST_CASE("Products of inertia turn with the solid, and inside out it weighs the same") {
  // A bar along x + y: about its center the integral of x y is (long^2 - short^2) / 24 of its volume.
  Mesh bar = box_mesh({0, 0, 0}, {4, 1, 1}, 1, never_stopped);
  Column<Point>& positions = bar.positions.edit();
  const double half = std::sqrt(0.5);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Point p = positions[i];
    positions.set(i, {half * (p.x - p.y), half * (p.x + p.y), p.z});
  }
  const MassProperties mass = mass_properties(bare(bar), never_stopped);
  CHECK(mass.products.z == Approx(4.0 * (16 - 1) / 24));
  WeldedMesh inverted = bare(bar);
  for (Corners& corners : inverted.triangles) std::swap(corners[0], corners[1]);
  const MassProperties same = mass_properties(inverted, never_stopped);
  CHECK(length(same.inertia - mass.inertia) < 1e-12);
  CHECK(length(same.center - mass.center) < 1e-12);
}

TEST_CASE("A solid without volume has its center in the middle of its bounds and no inertia") {
  const Grid plate(3, 3, false, false, [](double u, double v) { return Point{u, v, 2}; });
  const MassProperties mass = mass_properties(bare(surface_of(plate).mesh), never_stopped);
  CHECK(length(mass.center - Vector{0.5, 0.5, 2}) < 1e-12);
  CHECK(mass.inertia == Vector{});
  CHECK(mass_properties({}, never_stopped).center == Vector{});
}

TEST_CASE("The least thickness is that of the thinnest wall") {
  const auto thickness = [](const Mesh& mesh) { return least_thickness(bare(mesh), never_stopped); };
  CHECK(thickness(box_mesh({1, 1, 1}, {3, 0.25, 2}, 4, never_stopped)) == Approx(0.25));
  CHECK(thickness(sphere_mesh({0, 0, 0}, 1, 64, 32, never_stopped)) == Approx(2).epsilon(0.01));
  CHECK(thickness(torus_mesh({0, 0, 0}, {0, 0, 1}, 1, 0.2, 96, 48, never_stopped)) == Approx(0.4).epsilon(0.01));
  const Mesh patch = zone(0.1, 0.3, 24, 96);
  const WallSurface surface = wall_surface(patch, never_stopped);
  CHECK(thickness(wall_along(surface, {0, 0.05, {}}, never_stopped)) == Approx(0.05).epsilon(0.02));
  const Grid plate(3, 3, false, false, [](double u, double v) { return Point{u, v, 2}; });
  CHECK(thickness(surface_of(plate).mesh) == 0);
  CHECK(thickness(Mesh{}) == 0);
}

TEST_CASE("Flat caps close every border with the volume below them") {
  const double low = sine_cosine(0.1).cosine, high = sine_cosine(0.3).cosine;
  const CappedMesh drum = closed(zone(0.1, 0.3, 60, 160), CapKind::flat);
  CHECK(drum.caps == 2);
  const Measures measures = measured(drum.mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  const auto below = [](double z) { return pi * (z - z * z * z / 3); };
  CHECK(measures.volume == Approx(below(low) - below(high)).epsilon(2e-3));
  CHECK(normals_match_faces(drum.mesh));
}

TEST_CASE("A border that is not seen whole from its middle is cut into ears") {
  const Measures measures = measured(closed(bent_prism(), CapKind::flat).mesh);
  CHECK(measures.closed);
  CHECK(std::abs(measures.volume) == Approx(10));
  CHECK(contacts_of(bare(closed(bent_prism(), CapKind::flat).mesh), 100, never_stopped).pairs == 0);
}

TEST_CASE("Domes on a zone of a sphere make the sphere whole") {
  for (const auto& [from, to] : {std::pair{0.1, 0.3}, {0.2, 0.25}, {0.05, 0.45}}) {
    CAPTURE(from, to);
    const CappedMesh ball = closed(zone(from, to, 30, 64), CapKind::dome, 12);
    const Measures measures = measured(ball.mesh);
    CHECK(measures.closed);
    CHECK(measures.euler == 2);
    for (std::size_t i = 0; i < ball.mesh.positions.size(); ++i) {
      CHECK(length(to_vector(ball.mesh.positions[i])) == Approx(1).epsilon(1e-3));
    }
    CHECK(normals_match_faces(ball.mesh));
  }
}

TEST_CASE("Domes on a pipe are half spheres, on a flat ring flat, and one ring is a cone") {
  const Grid pipe(5, 48, false, true, [](double u, double v) {
    const SineCosine around = sine_cosine(v);
    return Point{2 * around.cosine, 2 * around.sine, 3 * u};
  });
  const CappedMesh pill = closed(surface_of(pipe).mesh, CapKind::dome, 16);
  CHECK(std::abs(measured(pill.mesh).maximum.z - 5) < 1e-9);
  CHECK(std::abs(measured(pill.mesh).minimum.z + 2) < 1e-9);
  CHECK(std::abs(measured(pill.mesh).volume) == Approx(12 * pi + 4.0 / 3 * pi * 8).epsilon(1e-2));
  const Grid ring(3, 24, false, true, [](double u, double v) {
    const SineCosine around = sine_cosine(v);
    return Point{(1 + u) * around.cosine, (1 + u) * around.sine, 0};
  });
  const CappedMesh disk = closed(surface_of(ring).mesh, CapKind::dome, 3);
  CHECK(disk.caps == 2);
  CHECK(measured(disk.mesh).closed);
  CHECK(std::abs(measured(disk.mesh).maximum.z) < 2 * 4 + 1e-9);  // the outer border would need all of the plane
  CHECK(closed(surface_of(pipe).mesh, CapKind::dome, 1).mesh.positions.size() ==
        surface_of(pipe).mesh.positions.size() + 2 * 49);
}

TEST_CASE("Caps leave closed meshes alone, and refuse what they cannot close") {
  const Mesh ball = sphere_mesh({0, 0, 0}, 1, 12, 8, never_stopped);
  const CappedMesh same = closed(ball, CapKind::dome);
  CHECK(same.caps == 0);
  CHECK((*same.mesh.positions == *ball.positions));
  CHECK(capped(zone(0.1, 0.3, 5, 50), {CapKind::dome, 10, 900}, never_stopped).too_large);
  CHECK_FALSE(capped(zone(0.1, 0.3, 5, 50), {CapKind::dome, 10, 1100}, never_stopped).too_large);
  Mesh pinched;
  pinched.positions = Column<Point>(5);
  pinched.positions.set(1, {1, 0, 0});
  pinched.positions.set(2, {0, 1, 0});
  pinched.positions.set(3, {-1, 0, 0});
  pinched.positions.set(4, {0, -1, 0});
  pinched.triangles.edit().assign({{0, 1, 2}, {0, 3, 4}});
  CHECK(capped(pinched, {CapKind::flat, 1, 100}, never_stopped).fault == "borders meet in the vertex at (0, 0, 0)");
}
