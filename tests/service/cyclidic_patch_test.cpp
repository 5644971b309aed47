// The cyclidic patch of the examples: a point carried by two ratios of spheres.

#include "algebra/vector.h"
#include "tests/support/looked_up.h"

using namespace dini;
using namespace dini::support;

namespace {

/// The circle through three points, by its center and a unit normal.
struct Round {
  Vector center, normal;
  double radius = 0;
};

Round circle_through(const Vector& a, const Vector& b, const Vector& c) {
  const Vector p = b - a, q = c - a, n = cross(p, q);
  const Vector to_center = (dot(q, q) * cross(n, p) + dot(p, p) * cross(q, n)) / (2 * dot(n, n));
  return {a + to_center, n / length(n), length(to_center)};
}

/// A line of the patch: every `stride`-th value from `first`.
std::vector<Vector> line(const Json& values, std::size_t first, std::size_t stride, std::size_t count) {
  std::vector<Vector> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Json& value = values[first + i * stride];
    points.push_back({value[0], value[1], value[2]});
  }
  return points;
}

double distance_from(const Round& circle, const Vector& point) {
  const Vector offset = point - circle.center;
  const double height = dot(offset, circle.normal);
  return std::hypot(height, length(offset - height * circle.normal) - circle.radius);
}

Vector tangent(const Round& circle, const Vector& point) {
  return cross(circle.normal, point - circle.center) / circle.radius;
}

}  // namespace

TEST_CASE("Every line of the cyclidic patch is an arc of a circle, and the two families meet at right angles") {
  const Json graph = example("cyclidic_patch");
  for (const Json& parameters : {Json::object(), Json{{"bend_u", 0.3}, {"turn", -1.0}, {"reach", 1.0}}}) {
    const Json patch = looked_up(graph, "patch", parameters, true);
    REQUIRE(patch["axes"].size() == 2);
    const std::size_t rows = patch["axes"][0]["size"], columns = patch["axes"][1]["size"];
    std::vector<Round> along_columns, along_rows;
    const auto check_line = [](const std::vector<Vector>& points, std::vector<Round>& circles) {
      circles.push_back(circle_through(points.front(), points[points.size() / 2], points.back()));
      for (const Vector& point : points) REQUIRE(distance_from(circles.back(), point) < 1e-12);
    };
    for (std::size_t row = 0; row < rows; ++row)
      check_line(line(patch["values"], row * columns, 1, columns), along_columns);
    for (std::size_t column = 0; column < columns; ++column)
      check_line(line(patch["values"], column, columns, rows), along_rows);
    for (std::size_t row = 0; row < rows; row += 8) {
      const std::vector<Vector> points = line(patch["values"], row * columns, 1, columns);
      for (std::size_t column = 0; column < columns; column += 8) {
        const Vector& point = points[column];
        REQUIRE(std::abs(dot(tangent(along_columns[row], point), tangent(along_rows[column], point))) < 1e-11);
      }
    }
  }
}
