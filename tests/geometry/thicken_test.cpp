#include "geometry/thicken.h"

#include <cmath>

#include "geometry/box.h"
#include "geometry/contacts.h"
#include "geometry/merge.h"
#include "geometry/primitives.h"
#include "tests/geometry/grids.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

Mesh thick(const Mesh& mesh, const Wall& wall) {
  const WallSurface surface = wall_surface(mesh, never_stopped);
  INFO(surface.fault.value_or("no fault"));
  REQUIRE_FALSE(surface.fault);
  Mesh result = wall_along(surface, wall, never_stopped);
  INFO(mesh_defect(result).value_or("no defect"));
  CHECK_FALSE(mesh_defect(result));
  return result;
}

Mesh strip(std::size_t rows, std::size_t columns, bool around) {
  const Grid grid(rows, columns, false, around, [&](double u, double v) {
    const SineCosine at = sine_cosine(around ? v : 0.4 * v);
    return Point{at.cosine, at.sine, u + 0.1 * at.sine};
  });
  return surface_of(grid).mesh;
}

Mesh mesh_of_triangles(const std::vector<Vector>& places, const std::vector<Corners>& triangles) {
  Mesh mesh;
  mesh.positions = Column<Point>(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) mesh.positions.set(i, to_point(places[i]));
  mesh.triangles.edit().assign(triangles.begin(), triangles.end());
  return mesh;
}

constexpr double sphere_factor = 4.0 / 3 * pi;

double apart(const Point& a, const Point& b) { return length(to_vector(a) - to_vector(b)); }

}  // namespace

TEST_CASE("A wall is closed, and has twice the Euler number and the thickness of its surface") {
  struct Example {
    const char* name;
    Mesh mesh;
  };
  std::vector<Example> examples;
  examples.push_back({"sphere", sphere_mesh({0, 0, 0}, 1, 24, 12, never_stopped)});
  examples.push_back({"torus", torus_mesh({0, 0, 0}, {0, 0, 1}, 1, 0.4, 32, 16, never_stopped)});
  examples.push_back({"box", box_mesh({1, 2, 3}, {1, 2, 3}, 3, never_stopped)});
  examples.push_back({"patch", strip(7, 9, false)});
  examples.push_back({"pipe", strip(5, 16, true)});
  examples.push_back({"one triangle", mesh_of_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})});
  for (const auto& [name, mesh] : examples) {
    const Measures before = measured(mesh);
    for (const Wall& wall : {Wall{0, 0.05, {}}, Wall{0.05, 0, {}}, Wall{0.02, 0.03, {}}}) {
      CAPTURE(name, wall.front, wall.back);
      const Mesh result = thick(mesh, wall);
      const Measures after = measured(result);
      CHECK(after.closed);
      CHECK(after.euler == 2 * before.euler);
      CHECK(after.volume > 0);
      CHECK(after.volume == Approx(0.05 * before.area).epsilon(0.1));
      CHECK(after.triangles == 2 * before.triangles + 2 * before.boundary_edges);
      CHECK_FALSE(contact_of(wall_surface(mesh, never_stopped), wall, never_stopped));
    }
  }
}

TEST_CASE("The wall along a sphere is the shell between two spheres, with their normals") {
  const Mesh ball = sphere_mesh({0, 0, 0}, 1, 96, 48, never_stopped);
  const Mesh shell = thick(ball, {0.2, 0.3, {}});
  const double faceted = measured(ball).volume;
  CHECK(measured(shell).volume == Approx(faceted * (1.2 * 1.2 * 1.2 - 0.7 * 0.7 * 0.7)).epsilon(1e-12));
  CHECK(faceted == Approx(sphere_factor).epsilon(3e-3));
  for (std::size_t i = 0; i < shell.positions.size(); ++i) {
    const Vector place = to_vector(shell.positions[i]);
    const bool outer = i < ball.positions.size();
    CHECK(length(place) == Approx(outer ? 1.2 : 0.7).epsilon(1e-14));
    CHECK(length(shell.normals[i] - (outer ? 1 : -1) * normalized(place)) < 1e-12);
  }
}

TEST_CASE("The wall along a box has flat faces at even distances and sharp edges") {
  const Mesh box = box_mesh({0, 0, 0}, {2, 3, 4}, 4, never_stopped);
  CHECK(measured(thick(box, {0.5, 0, {}})).volume == Approx(3 * 4 * 5 - 24).epsilon(1e-13));
  CHECK(measured(thick(box, {0, 0.25, {}})).volume == Approx(24 - 1.5 * 2.5 * 3.5).epsilon(1e-13));
  const Mesh grown = offset(box, 0.5, never_stopped);
  CHECK(measured(grown).volume == Approx(60).epsilon(1e-13));
  CHECK((*grown.normals == *box.normals));
}

TEST_CASE("An offset of a torus is the torus with another tube, and back again") {
  const Mesh torus = torus_mesh({0, 0, 0}, {0, 0, 1}, 2, 0.5, 48, 24, never_stopped);
  const Mesh thicker = torus_mesh({0, 0, 0}, {0, 0, 1}, 2, 0.8, 48, 24, never_stopped);
  const Mesh grown = offset(torus, 0.3, never_stopped), back = offset(grown, -0.3, never_stopped);
  for (std::size_t i = 0; i < torus.positions.size(); ++i) {
    CHECK(apart(grown.positions[i], thicker.positions[i]) < 1e-13);
    CHECK(apart(back.positions[i], torus.positions[i]) < 1e-13);
  }
}

TEST_CASE("A wall that reaches beyond the center of a bend is told, with the thickness that fits") {
  const WallSurface ball = wall_surface(sphere_mesh({5, 0, 0}, 1, 48, 24, never_stopped), never_stopped);
  CHECK_FALSE(contact_of(ball, {0, 0.99, {}}, never_stopped));
  const std::optional<WallContact> inside = contact_of(ball, {0, 1.5, {}}, never_stopped);
  REQUIRE(inside);
  CHECK(1.5 * inside->fits == Approx(1).margin(0.002));
  // Only the inside of the torus bends around the wall's outside.
  const WallSurface torus =
      wall_surface(torus_mesh({0, 0, 0}, {0, 0, 1}, 1, 0.4, 64, 32, never_stopped), never_stopped);
  CHECK_FALSE(contact_of(torus, {0.59, 0, {}}, never_stopped));
  const std::optional<WallContact> outside = contact_of(torus, {1.2, 0, {}}, never_stopped);
  REQUIRE(outside);
  CHECK(1.2 * outside->fits == Approx(0.6).margin(0.003));
  CHECK(std::hypot(outside->place.x, outside->place.y) < 0.7);
}

TEST_CASE("Two sheets near one another leave room for half of their distance each") {
  const Grid low(6, 6, false, false, [](double u, double v) { return Point{u, v, 0}; });
  const Grid high(5, 7, false, false, [](double u, double v) { return Point{0.1 + v, 0.1 + u, 0.5}; });
  const std::vector<SharedMesh> both = {std::make_shared<const Mesh>(surface_of(low).mesh),
                                        std::make_shared<const Mesh>(surface_of(high).mesh)};
  const WallSurface surface = wall_surface(merge(both, never_stopped), never_stopped);
  // The lower one looks up or down, the upper one the other way; walls on both sides meet in the middle.
  CHECK_FALSE(contact_of(surface, {0.24, 0.24, {}}, never_stopped));
  const std::optional<WallContact> contact = contact_of(surface, {0.4, 0.4, {}}, never_stopped);
  REQUIRE(contact);
  CHECK(0.4 * contact->fits == Approx(0.25).margin(0.001));
}

TEST_CASE("A surface that meets itself leaves no room for a wall") {
  const WallSurface spindle =
      wall_surface(torus_mesh({0, 0, 0}, {0, 0, 1}, 1, 1.5, 48, 24, never_stopped), never_stopped);
  const std::optional<WallContact> contact = contact_of(spindle, {0, 0.1, {}}, never_stopped);
  REQUIRE(contact);
  CHECK(contact->fits < 1e-3);
}

TEST_CASE("A wall of varying thickness moves each place by its share") {
  const Mesh patch = strip(5, 6, false);
  const WallSurface surface = wall_surface(patch, never_stopped);
  Wall wall{0, 0.1, {}};
  RandomElements random(2);
  for (std::size_t i = 0; i < surface.welded.positions.size(); ++i) wall.shares.push_back(1.5 + random.number(0.5));
  const Mesh result = wall_along(surface, wall, never_stopped);
  CHECK_FALSE(mesh_defect(result));
  CHECK(measured(result).closed);
  const std::size_t count = patch.positions.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double depth = apart(result.positions[i], result.positions[count + i]);
    CHECK(depth == Approx(0.1 * wall.shares[surface.welded.vertex_of[i]]).epsilon(1e-12));
  }
}

TEST_CASE("Strips show the corners of a border, and go smoothly around a round one") {
  const Mesh plate =
      thick(mesh_of_triangles({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}), {0, 0.1, {}});
  CHECK(normals_match_faces(plate));
  CHECK(plate.positions.size() == 8 + 16);
  const Mesh pipe = thick(strip(3, 48, true), {0, 0.1, {}});
  CHECK(normals_match_faces(pipe));
}

TEST_CASE("Colors, texture coordinates, material and tiles go with a wall") {
  Mesh patch = strip(4, 5, false);
  patch.colors.edit().assign(patch.positions.size(), {0.1F, 0.2F, 0.3F, 1});
  patch.finish.metallic = 1;
  const Mesh result = thick(patch, {0, 0.1, {}});
  REQUIRE(result.colors.size() == result.positions.size());
  REQUIRE(result.uvs.size() == result.positions.size());
  CHECK(result.colors.back() == std::array<float, 4>{0.1F, 0.2F, 0.3F, 1});
  CHECK(result.finish == patch.finish);
  CHECK(result.tile_ends.back() == result.triangles.size());
}

TEST_CASE("Faults name the edge or the vertex, and nothing stays nothing") {
  const std::vector<Vector> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0.5}};
  const auto fault = [&](const std::vector<Corners>& triangles) {
    return wall_surface(mesh_of_triangles(places, triangles), never_stopped).fault.value_or("");
  };
  CHECK(fault({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}).find("from (0, 0, 0) to (1, 0, 0)") != std::string::npos);
  CHECK(fault({{0, 1, 2}, {0, 1, 3}}).find("the same way") != std::string::npos);
  CHECK(fault({{0, 1, 2}, {0, 3, 4}}) == "borders meet in the vertex at (0, 0, 0)");
  CHECK(fault({{0, 1, 2}, {1, 0, 3}}).empty());
  const WallSurface nothing = wall_surface(Mesh{}, never_stopped);
  CHECK_FALSE(nothing.fault);
  CHECK(wall_along(nothing, {0, 0.1, {}}, never_stopped).positions.empty());
  CHECK_FALSE(contact_of(nothing, {0, 0.1, {}}, never_stopped));
}
