#include "geometry/tube.h"

#include "geometry/frames.h"
#include "tests/geometry/grids.h"

using namespace dini;
using namespace dini::support;

namespace {

template <class Map>
Polyline curve_of(std::size_t count, bool closed, Map map) {
  Polyline curve{Column<Point>(count), closed};
  const std::size_t whole = closed ? count : count - 1;
  for (std::size_t i = 0; i < count; ++i) {
    curve.points.set(i, map(static_cast<double>(i) / static_cast<double>(whole)));
  }
  return curve;
}

Point circle_point(double t) {
  const SineCosine around = sine_cosine(t);
  return {2 * around.cosine, 2 * around.sine, 0};
}

/// A trefoil knot.
Point knot_point(double t) {
  const SineCosine two = sine_cosine(2 * t), three = sine_cosine(3 * t);
  return {(2 + three.cosine) * two.cosine, (2 + three.cosine) * two.sine, three.sine};
}

Mesh tube_of(const Polyline& curve, const TubeOptions& options) {
  Mesh mesh = tube(curve, options, never_stopped);
  const auto defect = mesh_defect(mesh);
  INFO(defect.value_or("no defect"));
  CHECK(!defect);
  CHECK(normals_match_faces(mesh));
  return mesh;
}

}  // namespace

TEST_CASE("The tube of a circle is a torus") {
  const Mesh mesh = tube_of(curve_of(128, true, circle_point), {.radius = 0.5, .sides = 64});
  CHECK(mesh.positions.size() == 128 * 64);
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 0);
  CHECK(measures.area == Approx(4 * pi * pi * 2 * 0.5).epsilon(2e-3));
  CHECK(measures.volume == Approx(2 * pi * pi * 2 * 0.25).epsilon(4e-3));
  CHECK(normal_error(mesh, [](const Point& p) { return torus_normal(p); }) < 1e-12);
}

TEST_CASE("The tube of a knot closes without a jump at the seam") {
  const Polyline curve = curve_of(200, true, knot_point);
  const Mesh mesh = tube_of(curve, {.radius = 0.2, .sides = 9});
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 0);
  // Across every step, the seam's too, corners move about as far as the curve does.
  for (std::size_t i = 0; i < 200; ++i) {
    for (std::size_t side = 0; side < 9; ++side) {
      const Vector here = to_vector(mesh.positions[i * 9 + side]);
      const Vector next = to_vector(mesh.positions[(i + 1) % 200 * 9 + side]);
      CHECK(length(next - here) < 1.6 * length(to_vector(curve.points[(i + 1) % 200]) - to_vector(curve.points[i])));
    }
  }
}

TEST_CASE("Frames do not turn about the curve") {
  // By definition the direction across changes along the tangent only.
  const Polyline helix = curve_of(400, false, [](double t) {
    return Point{sine_cosine(2 * t).cosine, sine_cosine(2 * t).sine, 3 * t};
  });
  const std::vector<CurvePiece> pieces = curve_pieces(helix, 1e3, never_stopped);
  REQUIRE(pieces.size() == 1);
  double total = 0;
  const std::vector<Frame> frames = frames_along(pieces[0], total, never_stopped);
  CHECK(total == Approx(std::sqrt(16 * pi * pi + 9)).epsilon(1e-4));
  for (std::size_t i = 1; i < frames.size(); ++i) {
    CHECK(std::abs(dot(frames[i].across, frames[i].tangent)) < 1e-14);
    const Vector change = frames[i].across - frames[i - 1].across;
    const Vector tangent = normalized(frames[i].tangent + frames[i - 1].tangent);
    CHECK(length(change - dot(change, tangent) * tangent) < 1e-5);
  }
}

TEST_CASE("An open tube is capped by flat disks") {
  const Polyline line = curve_of(5, false, [](double t) { return Point{0, 0, 3 * t}; });
  const Mesh mesh = tube_of(line, {.radius = 0.5, .sides = 8});
  CHECK(mesh.positions.size() == 5 * 8 + 2 * 9);
  const Measures measures = measured(mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  const double octagon = 8 * 0.5 * 0.25 * sine_cosine(1.0 / 8).sine;
  CHECK(measures.volume == Approx(3 * octagon).epsilon(1e-13));
  CHECK(measures.minimum.z == 0);
  CHECK(measures.maximum.z == 3);
  std::size_t flat = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) flat += std::abs(mesh.normals[i].z) == 1;
  CHECK(flat == 18);
}

TEST_CASE("The ends of an open arc stand square on it") {
  const Polyline arc = curve_of(30, false, [](double t) { return circle_point(t / 4); });
  const Mesh mesh = tube_of(arc, {.radius = 0.1, .sides = 6});
  CHECK(measured(mesh).closed);
  std::size_t square = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    square += length(mesh.normals[i] - Vector{0, -1, 0}) < 1e-12 || length(mesh.normals[i] - Vector{-1, 0, 0}) < 1e-12;
  }
  CHECK(square >= 14);
}

TEST_CASE("Infinity and the clip radius cut a tube into capped pieces") {
  SECTION("a sample at infinity") {
    const Polyline curve = curve_of(11, false, [](double t) {
      return t == 0.5 ? Point::at_infinity() : Point{t, 0, 0};
    });
    const Measures measures = measured(tube_of(curve, {.radius = 0.01}));
    CHECK(measures.closed);
    CHECK(measures.euler == 4);
  }
  SECTION("a closed curve that leaves the sphere and comes back") {
    const Polyline curve = curve_of(40, true, [](double t) {
      return Point{circle_point(t).x + 1, circle_point(t).y, 0};
    });
    const Mesh mesh = tube_of(curve, {.radius = 0.01, .clip_radius = 2});
    const Measures measures = measured(mesh);
    CHECK(measures.closed);
    CHECK(measures.euler == 2);
    // The ends lie on the sphere where the two circles meet: x = (4 + 1 - 4) / 2, to the sampling.
    CHECK(measures.maximum.x == Approx(0.5).margin(0.03));
    CHECK(measures.minimum.x == Approx(-1.01).margin(0.02));
  }
  SECTION("a line through infinity between two samples") {
    const Polyline curve = curve_of(40, true, [](double t) {
      const SineCosine half = sine_cosine((t + 0.0125) / 2);
      return Point{20 * half.sine / half.cosine, 0, 0};
    });
    const Mesh mesh = tube_of(curve, {.radius = 0.01});
    CHECK(measured(mesh).closed);
    CHECK(measured(mesh).euler == 2);
    // The longest step is the last one before infinity, not the slab back through the scene.
    double longest = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      longest = std::max(longest, std::abs(mesh.positions[a].x - mesh.positions[b].x));
    }
    CHECK(longest < 400);
  }
  SECTION("everything out of reach") {
    CHECK(tube_of(curve_of(9, true, circle_point), {.clip_radius = 1}).positions.empty());
    CHECK(tube_of(curve_of(9, true, [](double) { return Point::at_infinity(); }), {}).positions.empty());
  }
}

TEST_CASE("Curves without two distinct points give empty tubes") {
  CHECK(tube_of({}, {}).positions.empty());
  CHECK(tube_of({Column<Point>(1), false}, {}).positions.empty());
  CHECK(tube_of({Column<Point>(7), true}, {}).positions.empty());
  CHECK(tube_of(curve_of(9, true, circle_point), {.radius = 0}).positions.empty());
  CHECK(tube_of(curve_of(9, true, circle_point), {.radius = -1}).positions.empty());
}

TEST_CASE("Steps of length zero are skipped") {
  const Polyline line = curve_of(9, false, [](double t) { return Point{std::floor(4 * t), 0, 0}; });
  const Mesh mesh = tube_of(line, {.radius = 0.1, .sides = 4});
  CHECK(mesh.positions.size() == 5 * 4 + 2 * 5);
  const Polyline doubled = curve_of(64, true, [](double t) { return circle_point(std::floor(32 * t) / 32); });
  CHECK(measured(tube_of(doubled, {.radius = 0.1, .sides = 4})).euler == 0);
}

TEST_CASE("A curve that turns back on itself keeps unit normals") {
  Polyline curve{Column<Point>(3), false};
  curve.points.set(1, {1, 0, 0});
  const Mesh mesh = tube(curve, {}, never_stopped);
  CHECK(!mesh_defect(mesh));
}

TEST_CASE("Long tubes are cut into tiles") {
  const Polyline curve = curve_of(1000, true, circle_point);
  const Mesh mesh = tube_of(curve, {.radius = 0.1, .sides = 130});
  CHECK(mesh.tile_ends.size() == 16);
  CHECK(largest_tile(mesh) == 2 * 128 * 128);
}
