#include "gltf/lines.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/gltf/compare.h"
#include "tests/gltf/shapes.h"

using namespace dini;

namespace {

using namespace compare;

Polyline polyline_of(const std::vector<double>& xs, bool closed) {
  Polyline polyline;
  polyline.closed = closed;
  polyline.points = Column<Point>(xs.size());
  for (std::size_t i = 0; i < xs.size(); ++i) polyline.points.set(i, {xs[i], 0, 0});
  return polyline;
}

std::vector<std::vector<float>> runs_of(const std::vector<double>& xs, bool closed) {
  std::vector<std::vector<float>> result;
  FloatRuns runs;
  add_drawable_runs(polyline_of(xs, closed), runs, Cancel());
  std::size_t begin = 0;
  for (const std::size_t end : runs.ends) {
    auto& target = result.emplace_back();
    for (; begin < end; ++begin) target.push_back(runs.points[begin][0]);
  }
  CHECK(begin == runs.points.size());
  return result;
}

TEST_CASE("Points that cannot be drawn split a polyline") {
  constexpr double gap = std::numeric_limits<double>::infinity();
  using Runs = std::vector<std::vector<float>>;
  CHECK(runs_of({1, 2, 3}, false) == Runs{{1, 2, 3}});
  CHECK(runs_of({1, 2, 3}, true) == Runs{{1, 2, 3, 1}});
  CHECK(runs_of({1, 2, gap, 3, 4, 5}, false) == Runs{{1, 2}, {3, 4, 5}});
  CHECK(runs_of({1, 2, gap, 3, 4, 5}, true) == Runs{{3, 4, 5, 1, 2}});
  CHECK(runs_of({1, gap, 3, std::nan(""), 4, 1e300, 5}, true) == Runs{{5, 1}});
  CHECK(runs_of({gap, 1, 2}, true) == Runs{{1, 2}});
  CHECK(runs_of({gap, gap}, true).empty());
  CHECK(runs_of({1}, true).empty());
  CHECK(runs_of({}, true).empty());
  CHECK(runs_of({1, 2}, true) == Runs{{1, 2, 1}});
}

TEST_CASE("Polylines come back, few as strips and many as segments") {
  const std::size_t count = GENERATE(1, 64, 65, 500);
  std::vector<Polyline> polylines;
  for (std::size_t i = 0; i < count; ++i) {
    polylines.push_back(shapes::circle(5 + i % 7, 1, static_cast<double>(i)));
    polylines.back().closed = i % 2 == 0;
  }
  Scene scene;
  scene.parts.push_back({"rings", polylines, {0, 1, 0, 1}});
  const EncodedScene encoded = encode(scene);
  CHECK(encoded.triangles == 0);
  CHECK(encoded.file.find("KHR_draco_mesh_compression") == std::string::npos);
  const Scene decoded = decode(encoded.file);
  const auto& back = std::get<std::vector<Polyline>>(decoded.parts[0].shape);
  REQUIRE(back.size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(back[i].closed == polylines[i].closed);
    REQUIRE(back[i].points.size() == polylines[i].points.size());
    for (std::size_t k = 0; k < back[i].points.size(); ++k) {
      const Vector difference = to_vector(back[i].points[k]) - to_vector(polylines[i].points[k]);
      CHECK(std::abs(difference.x) <= encoded.position_error);
      CHECK(std::abs(difference.y) <= encoded.position_error);
      CHECK(std::abs(difference.z) <= encoded.position_error);
    }
  }
}

TEST_CASE("Points come back without those that cannot be drawn") {
  Column<Point> points(4);
  points.set(0, {1, 2, 3});
  points.set(1, Point::at_infinity());
  points.set(2, {0.1, 0.2, 0.3});
  points.set(3, {0, std::nan(""), 0});
  Scene scene;
  scene.parts.push_back({"dots", std::make_shared<const Column<Point>>(points), {}});
  const EncodedScene encoded = encode(scene);
  CHECK(encoded.vertices == 2);
  const Scene decoded = decode(encoded.file);
  const Column<Point>& back = *std::get<SharedColumn<Point>>(decoded.parts[0].shape);
  REQUIRE(back.size() == 2);
  CHECK(back[0] == Point{1, 2, 3});
  CHECK(back[1].x == Approx(0.1).margin(encoded.position_error));
}

}  // namespace
