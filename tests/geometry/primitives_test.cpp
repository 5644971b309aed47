#include "geometry/primitives.h"

#include "tests/geometry/grids.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("A sphere mesh is closed, looks outward and has the area and volume of a sphere") {
  const Point center{1, -2, 3};
  const Mesh mesh = sphere_mesh(center, 2, 128, 64, never_stopped);
  CHECK(!mesh_defect(mesh));
  CHECK(normals_match_faces(mesh));
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.vertices == 63 * 128 + 2);
  CHECK(measures.area == Approx(16 * pi).epsilon(1e-3));
  CHECK(measures.volume == Approx(32 * pi / 3).epsilon(2e-3));
  CHECK(measures.minimum.z == 1);
  CHECK(measures.maximum == Point{3, 0, 5});
  CHECK(normal_error(mesh, [&](const Point& p) { return (to_vector(p) - to_vector(center)) / 2.0; }) < 1e-14);
}

TEST_CASE("A torus mesh is closed, looks outward and has the area and volume of a torus") {
  const Vector axis = GENERATE(Vector{0, 0, 1}, Vector{0, 0, 0}, Vector{1, 2, -3}, Vector{-1e-200, 0, 0});
  const Mesh mesh = torus_mesh({5, 6, 7}, axis, 2, 0.5, 128, 64, never_stopped);
  CHECK(!mesh_defect(mesh));
  CHECK(normals_match_faces(mesh));
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 0);
  CHECK(measures.area == Approx(4 * pi * pi).epsilon(1e-3));
  CHECK(measures.volume == Approx(pi * pi).epsilon(2.1e-3));
}

TEST_CASE("The least primitives are closed too") {
  CHECK(measured(sphere_mesh({}, 1, 0, 0, never_stopped)).euler == 2);
  CHECK(measured(sphere_mesh({}, 1, 0, 0, never_stopped)).closed);
  CHECK(measured(torus_mesh({}, {0, 0, 1}, 2, 1, 0, 0, never_stopped)).closed);
}

TEST_CASE("A horn torus has one vertex in its middle") {
  const Mesh mesh = torus_mesh({}, {0, 0, 1}, 1, 1, 32, 16, never_stopped);
  CHECK(!mesh_defect(mesh));
  CHECK(mesh.positions.size() == 32 * 15 + 1);
  CHECK(measured(mesh).closed);
}

TEST_CASE("Primitives without a meaningful size are empty") {
  const double size = GENERATE(0.0, -1.0, std::numeric_limits<double>::infinity(), 1e17);
  CHECK(sphere_mesh({}, size, 8, 8, never_stopped).positions.empty());
  CHECK(torus_mesh({}, {0, 0, 1}, size, 1, 8, 8, never_stopped).positions.empty());
  CHECK(torus_mesh({}, {0, 0, 1}, 1, size, 8, 8, never_stopped).positions.empty());
  CHECK(sphere_mesh(Point::at_infinity(), 1, 8, 8, never_stopped).positions.empty());
}

TEST_CASE("Large primitives are not clipped") {
  CHECK(measured(sphere_mesh({}, 1e15, 16, 8, never_stopped)).euler == 2);
  CHECK(measured(torus_mesh({1e12, 0, 0}, {0, 0, 1}, 1e14, 1e13, 16, 8, never_stopped)).closed);
}
