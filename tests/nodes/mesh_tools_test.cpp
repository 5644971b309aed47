// Meshes made, refined and colored.

#include "geometry/curvature.h"
#include "geometry/measure.h"
#include "geometry/palette.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("A box is closed, has outward faces and its own volume") {
  const SharedMesh mesh =
      graph_of({{"it", make("box_mesh", {{"center", {1, 2, 3}}, {"size", {1, 2, 3}}, {"segments", 5}})}})
          .one<SharedMesh>("it");
  const Cancel cancel;
  const Measures measures = measure(*mesh, cancel);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.volume == Approx(6).epsilon(1e-14));
  CHECK(measures.triangles == 6 * 5 * 5 * 2);
  CHECK(graph_of({{"it", make("box_mesh", {{"size", {1, 0, 1}}})}}).problems("it").size() == 1);
}

TEST_CASE("Subdividing keeps the shape and makes four triangles of one") {
  const Json nodes = {{"ball", make("sphere_mesh", {{"segments", 12}, {"rings", 6}})},
                      {"it", make("subdivide", {{"shape", from("ball")}, {"levels", 2}})}};
  CatalogueGraph graph = graph_of(nodes);
  const SharedMesh coarse = graph.one<SharedMesh>("ball"), fine = graph.one<SharedMesh>("it");
  const Cancel cancel;
  const Measures before = measure(*coarse, cancel), after = measure(*fine, cancel);
  CHECK(after.triangles == 16 * before.triangles);
  CHECK(after.volume == Approx(before.volume).epsilon(1e-13));
  CHECK(after.closed);
  CHECK(fine->tile_ends.back() == fine->triangles.size());
  CHECK(fine->positions.size() <= graph.planned("it").outputs[0].vertices);
}

TEST_CASE("Estimated curvatures of a sphere and a torus tend to the true ones with the square of the step") {
  const Cancel cancel;
  const auto worst_torus = [&](int segments) {
    const SharedMesh mesh =
        graph_of(
            {{"it",
              make("torus_mesh",
                   {{"major_radius", 2}, {"minor_radius", 0.5}, {"segments", 4 * segments}, {"sides", segments}})}})
            .one<SharedMesh>("it");
    const Curvatures found = estimate_curvatures(*mesh, cancel);
    double worst = 0;
    for (std::size_t i = 0; i < found.gauss.size(); ++i) {
      const Point p = mesh->positions[i];
      const double r = std::hypot(p.x, p.y);
      worst = std::max(worst, std::abs(found.gauss[i] - (r - 2) / 0.5 / (0.5 * r)));
    }
    return worst;
  };
  CHECK(worst_torus(96) < 0.01);
  CHECK(worst_torus(96) < 0.3 * worst_torus(48));
  const SharedMesh ball =
      graph_of({{"it", make("sphere_mesh", {{"radius", 2}, {"segments", 128}, {"rings", 64}})}}).one<SharedMesh>("it");
  for (const double mean : estimate_curvatures(*ball, cancel).mean) CHECK(mean == Approx(0.5).epsilon(2e-3));
}

TEST_CASE("Curvature colors have zero in the middle of the palette and tell the extremes") {
  const Json nodes = {{"ball", make("sphere_mesh", {{"radius", 2}, {"segments", 96}, {"rings", 48}})},
                      {"it", make("curvature_color", {{"shape", from("ball")}, {"kind", "mean"}, {"range", 0.5}})}};
  CatalogueGraph graph = graph_of(nodes);
  CHECK(graph.one<double>("it.minimum") == Approx(0.5).epsilon(5e-3));
  CHECK(graph.one<double>("it.maximum") == Approx(0.5).epsilon(5e-3));
  const auto red = palette_color(Palette::diverging, 1.0);
  for (const auto& color : graph.one<SharedMesh>("it.shape")->colors) CHECK(std::abs(color[0] - red[0]) < 0.02);
}

TEST_CASE("A color by number is that of the palette, and the cyclic one goes around") {
  CHECK(palette_color(Palette::cyclic, 0.25) == palette_color(Palette::cyclic, 1.25));
  CHECK(palette_color(Palette::sequential, -3) == palette_color(Palette::sequential, 0));
  Json nodes = {
      {"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}})},
      {"it", make("color_by", {{"shape", from("ball")}, {"value", 5}, {"maximum", 10}, {"palette", "sequential"}})}};
  const SharedMesh mesh = graph_of(nodes).one<SharedMesh>("it");
  CHECK(static_cast<float>(mesh->color[1]) == palette_color(Palette::sequential, 0.5)[1]);
  nodes["it"]["inputs"]["maximum"] = 0;
  const SharedMesh middle = graph_of(nodes).one<SharedMesh>("it");
  CHECK(middle->color == mesh->color);
}
