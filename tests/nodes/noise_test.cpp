// Noise as a number and as a displacement, and smoothing, which undoes it.

#include "geometry/noise.h"

#include <cmath>

#include "tests/nodes/mesh_measures.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("Noise stays between -1 and 1, reaches far into both and is zero on average") {
  RandomElements random(21);
  double sum = 0, least = 0, most = 0;
  constexpr int count = 200'000;
  for (int k = 0; k < count; ++k) {
    const double value = simplex_noise(random.vector(1000), 5);
    least = std::min(least, value);
    most = std::max(most, value);
    sum += value;
  }
  CHECK(least >= -1);
  CHECK(most <= 1);
  CHECK(least < -0.8);
  CHECK(most > 0.8);
  CHECK(std::abs(sum / count) < 0.005);
}

TEST_CASE("Noise is smooth everywhere, across the faces of its cells too") {
  RandomElements random(22);
  for (int k = 0; k < 20'000; ++k) {
    const Vector at = random.vector(20), way = normalized(random.vector());
    constexpr double step = 1e-4;
    const double before = simplex_noise(at - step * way, 1), here = simplex_noise(at, 1),
                 after = simplex_noise(at + step * way, 1);
    // Its slope is below 8 and its second derivative below 200: a step over a fault would be far more.
    CHECK(std::abs(after - here) < 8 * step);
    CHECK(std::abs(after - 2 * here + before) < 200 * step * step);
  }
}

TEST_CASE("Noise depends on the seed, and is what it was") {
  RandomElements random(23);
  double product = 0, square = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Vector at = random.vector(100);
    const double one = simplex_noise(at, 1), two = simplex_noise(at, 2);
    product += one * two;
    square += one * one;
  }
  CHECK(std::abs(product) < 0.03 * square);
  // Files depend on it: the same bits on every machine.
  NoiseSettings settings;
  const Vector at{0.3, -1.7, 2.9};
  CHECK(layered_noise(at, settings) == layered_noise(at, settings));
  settings.octaves = 1;
  settings.frequency = 0;
  CHECK(layered_noise(at, settings) == layered_noise({5, 6, 7}, settings));
}

TEST_CASE("One layer of noise is simplex noise of its frequency, and more layers are finer") {
  RandomElements random(24);
  const auto roughness_of = [&](int octaves) {
    const NoiseSettings settings{2, octaves, 0.8, 3};
    double sum = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vector at = random.vector(5);
      const double change = layered_noise(at + Vector{1e-4, 0, 0}, settings) - layered_noise(at, settings);
      sum += change * change;
    }
    return sum;
  };
  CHECK(roughness_of(5) > 4 * roughness_of(1));
  for (int k = 0; k < 1000; ++k) {
    const double value = layered_noise(random.vector(50), {3, 6, 1, 9});
    CHECK(std::abs(value) <= 1);
  }
}

TEST_CASE("There is no noise at infinity, and no numbers that are none") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double far : {1e13, 1e300, infinity, -infinity}) {
    CHECK(simplex_noise({far, 0, 0}, 1) == 0);
    CHECK(simplex_noise({far, -far, far}, 1) == 0);
    CHECK(simplex_noise({far, far, far}, 1) == 0);
  }
}

TEST_CASE("The three numbers of a noise vector and its number are independent") {
  RandomElements random(25);
  std::array<double, 4> values;
  std::array<std::array<double, 4>, 4> products{};
  for (int k = 0; k < 20'000; ++k) {
    const Vector at = random.vector(100);
    const NoiseSettings settings{1, 2, 0.5, 4};
    const Vector v = layered_noise_vector(at, settings);
    values = {layered_noise(at, settings), v.x, v.y, v.z};
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) products[a][b] += values[a] * values[b];
    }
  }
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < a; ++b) CHECK(std::abs(products[a][b]) < 0.04 * products[a][a]);
  }
}

TEST_CASE("A roughened closed mesh stays closed, and moves by the noise along its normals") {
  Json nodes = {{"ball", make("sphere_mesh", {{"segments", 48}, {"rings", 24}})},
                {"it", make("roughen", {{"shape", from("ball")}, {"amplitude", 0.2}, {"octaves", 2}})}};
  CatalogueGraph graph = graph_of(nodes);
  const SharedMesh ball = graph.one<SharedMesh>("ball"), rough = graph.one<SharedMesh>("it");
  const Measures measures = measures_of(*rough);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  double most = 0;
  for (std::size_t i = 0; i < rough->positions.size(); ++i) {
    const double height = length(to_vector(rough->positions[i])) - 1;
    CHECK(height == Approx(0.2 * layered_noise(to_vector(ball->positions[i]), {2, 2, 0.5, 1})).margin(2e-3));
    most = std::max(most, std::abs(height));
  }
  CHECK(most > 0.05);
  nodes["it"]["inputs"]["amplitude"] = 0;
  CHECK((graph_of(nodes).one<SharedMesh>("it")->positions == ball->positions));
  // The faces of a box have vertices of their own along its edges.
  const Json box = {{"box", make("box_mesh", {{"segments", 12}})}, {"it", make("roughen", {{"shape", from("box")}})}};
  CHECK(measures_of(*graph_of(box).one<SharedMesh>("it")).closed);
}

TEST_CASE("Roughened points move by the vector of the noise") {
  const Json nodes = {{"p", make("point", {{"position", {0.2, 0.4, -1.3}}})},
                      {"n", make("noise", {{"point", from("p")}, {"seed", 8}})},
                      {"it", make("roughen", {{"shape", from("p")}, {"amplitude", 0.5}, {"seed", 8}})}};
  CatalogueGraph graph = graph_of(nodes);
  require_close(graph.one<Point>("it"), to_point(Vector{0.2, 0.4, -1.3} + 0.5 * graph.one<Vector>("n.vector")));
}

TEST_CASE("Smoothing takes the bumps away and keeps the volume, or shrinks when it may") {
  Json nodes = {{"ball", make("sphere_mesh", {{"segments", 64}, {"rings", 32}})},
                {"rough", make("roughen", {{"shape", from("ball")}, {"amplitude", 0.05}, {"frequency", 12}})},
                {"it", make("smooth", {{"shape", from("rough")}, {"iterations", 20}})}};
  const auto roughness_of = [](const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const double off = length(to_vector(mesh.positions[i])) - 1;
      sum += off * off;
    }
    return sum;
  };
  CatalogueGraph graph = graph_of(nodes);
  const SharedMesh rough = graph.one<SharedMesh>("rough"), smooth = graph.one<SharedMesh>("it");
  const Measures before = measures_of(*rough), after = measures_of(*smooth);
  CHECK(after.closed);
  CHECK(after.euler == 2);
  CHECK(after.volume == Approx(before.volume).epsilon(0.01));
  CHECK(after.area < before.area);
  CHECK(roughness_of(*smooth) < 0.5 * roughness_of(*rough));
  nodes["it"]["inputs"]["keep_volume"] = false;
  CHECK(measures_of(*graph_of(nodes).one<SharedMesh>("it")).volume < 0.99 * before.volume);
}

TEST_CASE("Smoothing rounds a box without opening it, and at full strength stays bounded") {
  for (const bool keep : {true, false}) {
    const Json nodes = {
        {"box", make("box_mesh", {{"segments", 8}})},
        {"it", make("smooth", {{"shape", from("box")}, {"iterations", 300}, {"strength", 1}, {"keep_volume", keep}})}};
    const Measures measures = measures_of(*graph_of(nodes).one<SharedMesh>("it"));
    CAPTURE(keep);
    CHECK(measures.closed);
    CHECK(measures.euler == 2);
    // It becomes a ball, whose box is larger than the one of the same volume that it began with.
    const double ball = 2 * std::sqrt(3.0) * std::cbrt(3 / (4 * 3.14159265358979323846));
    CHECK(measures.diagonal < (keep ? ball : std::sqrt(3.0)));
    CHECK(measures.area < 6);
  }
}

TEST_CASE("A flat sheet smoothed with its border stays, without it the border gets round") {
  Json nodes = {{"g", make("grid", {{"count_u", 6}, {"count_v", 6}})},
                {"sheet", make("surface", {{"shape", from("g")}})},
                {"it", make("smooth", {{"shape", from("sheet")}, {"iterations", 50}})}};
  CatalogueGraph graph = graph_of(nodes);
  const SharedMesh sheet = graph.one<SharedMesh>("sheet"), smooth = graph.one<SharedMesh>("it");
  for (std::size_t i = 0; i < sheet->positions.size(); ++i) {
    const Point p = sheet->positions[i];
    if (std::max(std::abs(p.x), std::abs(p.y)) == 1) CHECK(smooth->positions[i] == p);
    CHECK(smooth->positions[i].z == 0);
  }
  nodes["it"]["inputs"].update({{"keep_border", false}, {"keep_volume", false}});
  const Measures rounded = measures_of(*graph_of(nodes).one<SharedMesh>("it"));
  CHECK(rounded.area < 3.9);
  CHECK(rounded.area > 0.5);
  CHECK(rounded.boundary_edges == 20);
}

TEST_CASE("Smoothing nothing and smoothing not at all give what was there") {
  const Json nodes = {{"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}})},
                      {"none", make("smooth", {{"shape", from("ball")}, {"iterations", 0}})},
                      {"weak", make("smooth", {{"shape", from("ball")}, {"strength", 0}})},
                      {"same", make("list", {{"items", {{0, 0, 0}, {0, 0, 0}}}})},
                      {"empty", make("tube", {{"shape", from("same")}})},
                      {"it", make("smooth", {{"shape", from("empty")}})}};
  CatalogueGraph graph = graph_of(nodes);
  CHECK((graph.one<SharedMesh>("none")->positions == graph.one<SharedMesh>("ball")->positions));
  CHECK((graph.one<SharedMesh>("weak")->positions == graph.one<SharedMesh>("ball")->positions));
  CHECK(graph.one<SharedMesh>("it")->triangles.empty());
}
