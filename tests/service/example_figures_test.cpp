// What must hold of the figures of the paper, looked up in the example graphs as a user would.

#include <filesystem>

#include "algebra/vector.h"
#include "tests/support/looked_up.h"
#include "tests/support/triple.h"

using namespace dini;
using namespace dini::support;

namespace {

double at(const Json& answer, std::size_t index) { return answer["values"][index].get<double>(); }

/// How often two closed curves wind around each other: the Gauss integral over polygons, a whole number up to
/// round-off.
double linking(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector da = a[(i + 1) % a.size()] - a[i], pa = 0.5 * (a[i] + a[(i + 1) % a.size()]);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Vector db = b[(j + 1) % b.size()] - b[j], r = pa - 0.5 * (b[j] + b[(j + 1) % b.size()]);
      sum += dot(cross(da, db), r) / std::pow(length(r), 3);
    }
  }
  return sum / (16 * std::atan(1.0));
}

std::vector<Vector> polygon(const Json& circle) {
  const Vector normal = triple(circle["normal"]), ahead = any_perpendicular(normal), left = cross(normal, ahead);
  std::vector<Vector> points;
  for (int i = 0; i < 240; ++i) {
    const double angle = i * (std::atan(1.0) * 8 / 240);
    points.push_back(triple(circle["center"]) +
                     circle["radius"].get<double>() * (std::cos(angle) * ahead + std::sin(angle) * left));
  }
  return points;
}

}  // namespace

TEST_CASE("Every example graph evaluates, and says for which figure it stands") {
  for (const auto& file : std::filesystem::directory_iterator(DINI_EXAMPLES)) {
    if (file.path().extension() != ".json") continue;
    CAPTURE(file.path().string());
    const Json graph = example(file.path().stem().string());
    CHECK_FALSE(graph["meta"]["title"].get<std::string>().empty());
    CHECK(looked_up(graph, "out")["type"] == "asset");
  }
}

TEST_CASE("Fig. 1: the circle boosted in its plane has its center at l/(l^2-1) and is a line at 1, reversed beyond") {
  const Json graph = example("fig01_boosted_in_plane");
  const Json k = looked_up(graph, "k"), circles = looked_up(graph, "boosted");
  bool line_seen = false;
  for (std::size_t i = 0; i < k["values"].size(); ++i) {
    const double l = at(k, i);
    const Json& circle = circles["values"][i];
    if (circle.contains("line")) {
      line_seen = true;
      CHECK(l == 1);
      require_near(circle["point"], {0.5, 0, 0}, 1e-15);
      continue;
    }
    // The condition of both numbers near the line is that of 1/(l^2-1).
    const double tolerance = 1e-14 / std::abs(l * l - 1);
    require_near(circle["center"], {l / (l * l - 1), 0, 0}, tolerance);
    require_near(circle["radius"], 1 / std::abs(l * l - 1), tolerance);
    require_near(circle["normal"], {0, 0, l < 1 ? 1 : -1}, 1e-14);
  }
  CHECK(line_seen);
}

TEST_CASE("Fig. 2: the circle boosted along its normal has its center at l/(1+l^2) and the radius 1/(1+l^2)") {
  const Json graph = example("fig02_boosted_circle");
  const Json k = looked_up(graph, "k"), circles = looked_up(graph, "boosted");
  for (std::size_t i = 0; i < k["values"].size(); ++i) {
    const double l = at(k, i);
    require_near(circles["values"][i]["center"], {0, 0, l / (1 + l * l)}, 1e-14);
    require_near(circles["values"][i]["radius"], 1 / (1 + l * l), 1e-14);
  }
}

TEST_CASE(
    "Fig. 3: both rules give the same loxodromes when the directions are parallel, and others when they are not") {
  const Json graph = example("fig03_loxodromes");
  const auto farthest = [&](double angle) {
    const Json exact = looked_up(graph, "carried", {{"angle", angle}, {"reach", 0.7}, {"rule", "exact"}});
    const Json paper = looked_up(graph, "carried", {{"angle", angle}, {"reach", 0.7}, {"rule", "paper"}});
    double most = 0;
    for (std::size_t i = 0; i < exact["values"].size(); ++i) {
      most = std::max(most, length(triple(exact["values"][i]) - triple(paper["values"][i])));
    }
    return most;
  };
  CHECK(farthest(0) < 1e-11);
  CHECK(farthest(180) < 1e-11);
  CHECK(farthest(90) > 0.1);
}

TEST_CASE("Fig. 4: the boosted ring lies on a horn torus, and its Gauss curvature is cos(th)/(a r)") {
  const Json graph = example("fig04_boosted_ring");
  const double h = 1.5, a = (1 + h * h) / 2;
  const Json circles = looked_up(graph, "boosted");
  double least = 1e9, most = -1e9;
  for (const Json& circle : circles["values"]) {
    const double r = circle["radius"], height = circle["center"][2].get<double>() - h;
    CHECK(std::abs(std::hypot(r - a, height) - a) < 1e-12);
    const double curvature = (r - a) / a / (a * r);
    least = std::min(least, curvature);
    most = std::max(most, curvature);
  }
  // Least squares over triangles: second order inside, first order at the two borders, where the extremes are.
  CHECK(std::abs(looked_up(graph, "paint.minimum")["values"][0].get<double>() - least) < 0.02 * std::abs(least));
  CHECK(std::abs(looked_up(graph, "paint.maximum")["values"][0].get<double>() - most) < 0.02);
}

TEST_CASE("The exact pseudosphere has the Gauss curvature -1 everywhere") {
  const Json graph = example("exact_pseudosphere");
  const Json u = looked_up(graph, "u"), circles = looked_up(graph, "tractrix");
  for (std::size_t i = 0; i < u["values"].size(); ++i) {
    require_near(circles["values"][i]["radius"], 1 / std::cosh(at(u, i)), 1e-14);
    require_near(circles["values"][i]["center"], {0, 0, at(u, i) - std::tanh(at(u, i))}, 1e-14);
  }
  CHECK(looked_up(graph, "paint.minimum")["values"][0].get<double>() > -1.1);
  CHECK(looked_up(graph, "paint.maximum")["values"][0].get<double>() < -0.9);
}

TEST_CASE("Fig. 5: the points of the twisted ring lie on a horn torus that is carried along the screw") {
  const Json graph = example("fig05_twisted_ring");
  for (const Json& parameters : {Json::object(), Json{{"turns", 1.3}, {"pitch", 1.1}, {"reach", 1.7}}}) {
    const double pitch = parameters.value("pitch", 0.55);
    const Json turns = looked_up(graph, "turn", parameters), amounts = looked_up(graph, "k", parameters);
    const Json points = looked_up(graph, "boosted", parameters);
    const double h = 1.5, a = (1 + h * h) / 2;
    REQUIRE(points["axes"][0]["name"] == "turn");
    const std::size_t columns = amounts["values"].size();
    for (std::size_t i = 0; i < points["values"].size(); ++i) {
      const Vector point = triple(points["values"][i]);
      const double turn = at(turns, i / columns), across = std::hypot(point.x, point.y);
      // Carried back along the screw, every point is on the circle of radius a through the generator, tangent to it.
      const double height = point.z + turn * pitch - h;
      CHECK(std::abs(std::hypot(across - a, height) - a) < 1e-12);
      const double angle = turn * (std::atan(1.0) * 8);
      CHECK(length(Vector{point.x, point.y, 0} - across * Vector{std::cos(angle), std::sin(angle), 0}) < 1e-11);
    }
  }
}

TEST_CASE("The exact surface of Dini has the Gauss curvature -1/(1+b^2) everywhere") {
  const Json graph = example("exact_dini");
  for (const double climb : {0.1, 0.2, 0.5}) {
    CAPTURE(climb);
    const double curvature = -1 / (1 + climb * climb);
    CHECK(looked_up(graph, "paint.minimum", {{"climb", climb}})["values"][0].get<double>() > 1.1 * curvature);
    CHECK(looked_up(graph, "paint.maximum", {{"climb", climb}})["values"][0].get<double>() < 0.9 * curvature);
  }
}

TEST_CASE(
    "Fig. 7: every pair of fibers links once, and the squared radius less that of the center is 1 only when exact") {
  const Json graph = example("fig07_hopf_fibers");
  const std::string method = GENERATE(as<std::string>{}, "paper", "exact");
  const Json chosen = {{"method", method}, {"fibers", 5}};
  const Json circles = looked_up(graph, "fibers", chosen), latitudes = looked_up(graph, "latitude", chosen);
  REQUIRE(circles["values"].size() == 15);
  const bool theta_first = circles["axes"][0]["name"] == "theta";
  std::vector<std::vector<Vector>> fibers;
  for (std::size_t i = 0; i < 15; ++i) {
    const double k = at(latitudes, theta_first ? i % 3 : i / 5);
    const Json& circle = circles["values"][i];
    const double r = circle["radius"], c = length(triple(circle["center"]));
    require_near(r * r - c * c, method == "exact" ? 1 : 1 - k * k / 4, 1e-12);
    fibers.push_back(polygon(circle));
  }
  for (std::size_t i = 0; i < fibers.size(); ++i) {
    for (std::size_t j = i + 1; j < fibers.size(); ++j) {
      CAPTURE(method, i, j);
      CHECK(std::abs(std::abs(linking(fibers[i], fibers[j])) - 1) < 0.05);
    }
  }
}

TEST_CASE("Fig. 13: the line becomes a circle of radius 1/kappa through the point, and comes back") {
  const Json graph = example("fig13_line_to_circle");
  const Json kappa = looked_up(graph, "kappa"), circles = looked_up(graph, "circles");
  for (std::size_t i = 1; i < kappa["values"].size(); ++i) {
    require_near(circles["values"][i]["radius"], 1 / at(kappa, i), 1e-14);
    require_near(circles["values"][i]["center"], {1 / at(kappa, i), 0, 0}, 1e-14);
  }
  CHECK(circles["values"][0]["line"] == true);
  const Json back = looked_up(graph, "back")["values"][0];
  REQUIRE(back["line"] == true);
  require_near(back["point"], {0, 0, 0}, 1e-14);
  require_near(back["direction"], {0, 1, 0}, 1e-14);
}

TEST_CASE("Fig. 16: the family of weights is on its closed form") {
  const Json graph = example("fig16_product_of_points");
  const Json weights = looked_up(graph, "weights"), amounts = looked_up(graph, "part"),
             circles = looked_up(graph, "carried");
  REQUIRE(circles["axes"][0]["name"] == "w");
  const std::size_t size = amounts["values"].size();
  for (std::size_t i = 0; i < weights["values"].size(); ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      const double w = at(weights, i), l = at(amounts, j), m = 2 * l / (1 + w), over = 1 + w * w * m * m;
      const Json& circle = circles["values"][i * size + j];
      require_near(circle["center"], {0, 0, 2 * l / over}, 1e-13);
      // Near a pole the radius is a root of a difference: half the digits.
      require_near(circle["radius"], std::abs(1 - w * m * m) / over, w == 1 && std::abs(l) > 0.99 ? 1e-7 : 1e-13);
    }
  }
}
