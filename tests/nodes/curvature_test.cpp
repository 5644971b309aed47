// Curvatures as asked for: on lines, planes and patches, measured by differences.

#include <array>

#include "algebra/extract.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

/// The normal curvatures along u and along v at the middle of the bent plane, positive bending away from the normal.
std::array<double, 2> measured(double along_u, double along_v, const std::string& method, double step) {
  const auto height = [&](double u, double v) {
    const Json nodes = {
        {"spot", make("point", {{"position", {u, v, 0}}})},
        {"operator",
         make("curvature",
              {{"curvature_u", along_u}, {"curvature_v", along_v}, {"u", u}, {"v", v}, {"method", method}})},
        {"bent", make("boost", {{"shape", from("spot")}, {"generator", from("operator")}})}};
    const Point bent = graph_of(nodes).one<Point>("bent");
    const double across = bent.x * bent.x + bent.y * bent.y;
    return -2 * bent.z / across;
  };
  // Even functions of the step: Richardson's extrapolation takes away the error of second order.
  const auto refined = [&](double u, double v) {
    const double coarse = (height(2 * u, 2 * v) + height(-2 * u, -2 * v)) / 2,
                 fine = (height(u, v) + height(-u, -v)) / 2;
    return (4 * fine - coarse) / 3;
  };
  return {refined(step, 0), refined(0, step)};
}

}  // namespace

TEST_CASE("Eq. 17 bends a line to a circle of the curvature asked for, through the point") {
  for (const double kappa : {-2.0, 0.001, 0.5, 3.0}) {
    CAPTURE(kappa);
    const Json nodes = {
        {"line", make("line", {{"point", {1, 2, 3}}, {"direction", {0, 1, 0}}})},
        {"operator",
         make("curvature",
              {{"position", {1, 2, 3}}, {"normal", {2, 0, 0}}, {"u_direction", {0, 1, 0}}, {"curvature_u", kappa}})},
        {"bent", make("boost", {{"shape", from("line")}, {"generator", from("operator")}})}};
    const auto circle = coordinates(graph_of(nodes).one<Circle>("bent"));
    REQUIRE_FALSE(circle->line);
    CHECK(circle->radius == Approx(1 / std::abs(kappa)).epsilon(1e-9));
    require_close(circle->center, {1 - 1 / kappa, 2, 3}, 1e-9);
  }
}

TEST_CASE("The principal curvatures at the middle are the ones asked for") {
  for (const auto& [u, v] : std::vector<std::array<double, 2>>{{1, 0}, {1, 0.4}, {1, 1}, {1, -1}, {-0.3, 2}}) {
    CAPTURE(u, v);
    const std::array<double, 2> found = measured(u, v, "exact", 1e-2);
    CHECK(std::abs(found[0] - u) < 1e-6);
    CHECK(std::abs(found[1] - v) < 1e-6);
  }
}

TEST_CASE("Eq. 18 to the letter exchanges u and v and doubles, with the other sign") {
  const std::array<double, 2> found = measured(1, 0.4, "paper", 1e-2);
  CHECK(std::abs(found[0] - -0.8) < 1e-6);
  CHECK(std::abs(found[1] - -2) < 1e-6);
}

TEST_CASE("A zero normal is an error, a u_direction along the normal is replaced") {
  CatalogueGraph zero = graph_of({{"it", make("curvature", {{"normal", {0, 0, 0}}})}});
  REQUIRE(zero.problems("it").size() == 1);
  CHECK(zero.problems("it").front().code == "degenerate");
  CHECK(graph_of({{"it", make("curvature", {{"u_direction", {0, 0, 1}}, {"u", 1}})}}).problems("it").empty());
}

TEST_CASE("A curvature patch has the curvatures asked for at its corners") {
  const std::size_t count = 801;
  const Json patch = make("curvature_patch", {{"curvature_u_a", 1.5},
                                              {"curvature_v_a", -0.7},
                                              {"curvature_u_b", -1},
                                              {"curvature_v_b", 0.4},
                                              {"curvature_u_c", 0.2},
                                              {"curvature_v_c", 2},
                                              {"count_u", count},
                                              {"count_v", count}});
  const SharedMesh mesh = graph_of({{"it", patch}}).one<SharedMesh>("it");
  const auto point = [&](std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < mesh->uvs.size(); ++k) {
      const double u = static_cast<double>(i) / (count - 1), v = static_cast<double>(j) / (count - 1);
      if (mesh->uvs[k][0] == u && mesh->uvs[k][1] == v) return to_vector(mesh->positions[k]);
    }
    FAIL("no vertex there");
    return Vector{};
  };
  // -2 z / distance^2 tends to the normal curvature; its error is of first order in the step.
  const auto along = [&](std::size_t i, std::size_t j, std::size_t di, std::size_t dj) {
    const Vector corner = point(i, j);
    const auto bend = [&](std::size_t steps) {
      const Vector there = point(i + steps * di, j + steps * dj) - corner;
      return -2 * there.z / (there.x * there.x + there.y * there.y);
    };
    return 2 * bend(1) - bend(2);
  };
  require_close(point(0, 0), {-1, -1, 0}, 1e-15);
  CHECK(along(0, 0, 1, 0) == Approx(1.5).epsilon(1e-3));
  CHECK(along(0, 0, 0, 1) == Approx(-0.7).epsilon(1e-3));
  CHECK(along(count - 1, 0, 0, 1) == Approx(0.4).epsilon(1e-3));
  CHECK(along(0, count - 1, 1, 0) == Approx(0.2).epsilon(1e-3));
}
