#include "tests/geometry/grids.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Inverts p in the unit sphere around the origin: the origin goes to infinity.
Point inverted(const Point& p) {
  const double square = squared_length(to_vector(p));
  return square == 0 ? Point::at_infinity() : to_point(to_vector(p) / square);
}

double farthest(const Mesh& mesh) {
  double farthest = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    farthest = std::max(farthest, length(to_vector(mesh.positions[i])));
  }
  return farthest;
}

/// The longest edge of a mesh, in meters.
double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(
          longest, length(to_vector(mesh.positions[triangle[k]]) - to_vector(mesh.positions[triangle[(k + 1) % 3]])));
    }
  }
  return longest;
}

}  // namespace

TEST_CASE("A sheet with a sample at infinity is cut on the clip sphere") {
  // The plane around the origin, inverted: the middle sample is at infinity.
  const Grid grid(41, 41, false, false, [](double u, double v) {
    return inverted({0.02 * std::round(40 * u - 20), 0.02 * std::round(40 * v - 20), 0});
  });
  const SurfaceResult result = surface_of(grid, {.clip_radius = 20});
  CHECK(result.clipped_quads > 4);
  CHECK(result.clipped_quads < 100);
  REQUIRE(result.first_clipped);
  CHECK((*result.first_clipped)[0] < 20);
  CHECK(farthest(result.mesh) <= 20 * (1 + 1e-14));
  CHECK(farthest(result.mesh) >= 20 * (1 - 1e-14));
  CHECK(normals_match_faces(result.mesh));
  for (std::size_t i = 0; i < result.mesh.normals.size(); ++i) CHECK(result.mesh.normals[i].z == Approx(-1));
  // One hole at infinity and one border: a ring. Had the cut vertices not been shared, there would be more edges.
  const Measures measures = measured(result.mesh);
  CHECK(measures.euler == 0);
}

TEST_CASE("A saddle that leaves the clip sphere keeps a clean border") {
  const Grid grid(30, 30, false, false, [](double u, double v) {
    const double x = 8 * (u - 0.5), y = 8 * (v - 0.5);
    return Point{x, y, x * y};
  });
  const SurfaceResult result = surface_of(grid, {.clip_radius = 3});
  CHECK(farthest(result.mesh) <= 3 * (1 + 1e-14));
  CHECK(measured(result.mesh).euler == 1);
  CHECK(normals_match_faces(result.mesh));
  std::size_t on_sphere = 0;
  for (std::size_t i = 0; i < result.mesh.positions.size(); ++i) {
    const Point p = result.mesh.positions[i];
    if (length(to_vector(p)) > 3 - 1e-9) ++on_sphere;
    CHECK(length(result.mesh.normals[i] - normalized(Vector{-p.y, -p.x, 1})) < 0.05);
    CHECK(result.mesh.uvs[i][0] == Approx(p.x / 8 + 0.5));
    CHECK(result.mesh.uvs[i][1] == Approx(p.y / 8 + 0.5));
  }
  // Every border edge lies on the sphere: the border is as long as it has vertices.
  CHECK(measured(result.mesh).boundary_edges == on_sphere);
}

TEST_CASE("Texture coordinates of a cut at a welded seam do not run backwards") {
  const Grid grid(12, 8, true, false, [](double u, double v) {
    const SineCosine around = sine_cosine(u);
    return Point{around.cosine, around.sine, 4 * v};
  });
  const Mesh mesh = surface_of(grid, {.clip_radius = 2}).mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double turn = angle_of(mesh.positions[i].x, std::abs(mesh.positions[i].y)) / (2 * pi);
    const double u = mesh.positions[i].y < -1e-9 ? 1 - turn : turn;
    CHECK(std::abs(mesh.uvs[i][0] - u) < 0.01);
  }
}

TEST_CASE("Fail reports the first sample at infinity and gives no mesh") {
  const Grid grid(5, 7, false, false, [](double u, double v) {
    return u == 0.5 && v > 0.3 ? Point::at_infinity() : Point{u, v, 0};
  });
  const SurfaceResult result = surface_of(grid, {.at_infinity = AtInfinity::fail});
  CHECK(result.mesh.positions.empty());
  REQUIRE(result.first_clipped);
  CHECK(*result.first_clipped == std::array<std::size_t, 2>{2, 2});
  CHECK(surface_of(grid).clipped_quads == 10);
}

TEST_CASE("Positions far beyond any encoder's range do no harm") {
  const double far = GENERATE(1e17, 1e30, 1e160, 1e300, 1.7e308);
  const Grid grid(9, 9, false, false, [&](double u, double v) {
    return u > 0.8 ? Point{far, -far * v, far} : v > 0.8 ? Point{-far, 0, 0} : Point{u, v, 0};
  });
  const SurfaceResult result = surface_of(grid);
  CHECK(farthest(result.mesh) <= 1e3 * (1 + 1e-14));
  CHECK(result.clipped_quads > 0);
  const SurfaceResult unlimited = surface_of(grid, {.clip_radius = std::numeric_limits<double>::infinity()});
  CHECK(farthest(unlimited.mesh) < 1e18);
}

TEST_CASE("A clip radius without meaning leaves nothing") {
  const Grid grid(4, 4, false, false, [](double u, double v) { return Point{u + 1, v, 0}; });
  for (const double radius : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(surface_of(grid, {.clip_radius = radius}).mesh.positions.empty());
  }
}

TEST_CASE("A surface that runs through infinity between two rows is torn there") {
  // x = 1/t: rows on both sides of t = 0, none on it.
  const Grid grid(40, 10, false, false, [](double u, double v) { return Point{1 / (u - 0.5), v, 0.1 * v * v}; });
  const SurfaceResult result = surface_of(grid);
  CHECK(result.clipped_quads == 9);
  REQUIRE(result.first_clipped);
  CHECK(*result.first_clipped == std::array<std::size_t, 2>{19, 0});
  CHECK(longest_edge(result.mesh) < 60);
  CHECK(measured(result.mesh).euler == 2);  // two sheets
  for (std::size_t i = 0; i < result.mesh.normals.size(); ++i) {
    // x falls along rows, so the normal looks down; sheer one-sided differences give it at the tear.
    const Vector exact = normalized(Vector{0, 0.2 * result.mesh.positions[i].y, -1});
    CHECK(length(result.mesh.normals[i] - exact) < 1e-6);
  }
}

TEST_CASE("The one quad that holds infinity is torn out, wherever in it infinity lies") {
  const double offset_u = GENERATE(0.02, 0.3, 0.5, 0.77, 0.98);
  const double offset_v = GENERATE(0.05, 0.5, 0.9);
  const Grid grid(41, 41, false, false, [&](double u, double v) {
    return inverted({(40 * u - 20 - offset_u) / 40, (40 * v - 20 - offset_v) / 40, 0});
  });
  const SurfaceResult result = surface_of(grid);
  CHECK(result.clipped_quads >= 1);
  CHECK(result.clipped_quads <= 4);
  REQUIRE(result.first_clipped);
  // The disk of radius 2 around the origin is the outside of the grid: nothing may cover it.
  for (const auto& triangle : result.mesh.triangles) {
    const auto corner = [&](std::size_t k) { return to_vector(result.mesh.positions[triangle[k]]); };
    CHECK(cross(corner(1) - corner(0), corner(2) - corner(0)).z < 0);
  }
}

TEST_CASE("Ordinary surfaces are never torn, however sharp their folds") {
  SECTION("a large triangular tube") {
    const Grid grid(3, 5, true, false, [](double u, double v) {
      return Point{300 * sine_cosine(u).cosine, 300 * sine_cosine(u).sine, 500 * v};
    });
    CHECK(surface_of(grid).clipped_quads == 0);
  }
  SECTION("a large flat box profile") {
    const Grid grid(4, 5, true, false, [](double u, double v) {
      return Point{u < 0.5 ? 500.0 : -500.0, std::fmod(u + 0.25, 1.0) < 0.5 ? 1.0 : -1.0, 500 * v};
    });
    CHECK(surface_of(grid).clipped_quads == 0);
  }
  SECTION("a small zigzag with one long step") {
    const double x[] = {0, 1, -1.5, -0.6};
    const Grid grid(4, 5, false, false, [&](double u, double v) {
      return Point{x[static_cast<std::size_t>(std::round(3 * u))], u, v};
    });
    CHECK(surface_of(grid).clipped_quads == 0);
  }
}
