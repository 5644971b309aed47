// What the table of reference numbers says beside images of points: squares of generators, weights, radii, and which
// products collapse. Relative to the size of what is compared, at least one, everything agrees to 1e-12. Squares
// of generators and radii of images are differences of larger numbers, so their size is that of those.

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "algebra/generator_kind.h"
#include "algebra/versor.h"
#include "geometry/json.h"
#include "tests/algebra/reference_elements.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

void require_number(double value, double expected, double size = 1) {
  INFO(value << " against " << expected);
  REQUIRE(std::abs(value - expected) <= 1e-12 * std::max({1.0, std::abs(expected), size}));
}

/// The scalar part of B B, and the square of its grade-4 part.
std::pair<double, double> squares(const Generator& generator) {
  const Versor b = versor_from(0, generator);
  const Versor square = compose(b, b);
  const Versor quad{0, {}, square.quad};
  return {square.scalar, compose(quad, quad).scalar};
}

/// The square of a generator, and the squared radius that the paper's rule leaves an image of a point.
void require_squares(const Generator& generator, const Json& item) {
  const auto [square, quad] = squares(generator);
  const double terms = generator.no_ni * generator.no_ni + squared_length(generator.e_e) +
                       2 * length(generator.no_e) * length(generator.e_ni);
  require_number(square, item["B_squared_scalar_part_before_s"], terms);
  require_number(quad, item["square_of_B_wedge_B"], terms * terms);
  const Vector p = triple(item["point"]);
  const Sphere image =
      apply(exponential(item["s"].get<double>() * generator, Rule::paper), Sphere{1, p, dot(p, p) / 2});
  const double size = squared_length(image.e) / (image.no * image.no);
  require_number(size - 2 * image.ni / image.no, item["paper_rule_radius_squared_of_result"], size);
}

TEST_CASE("Squares of blends of two and of four null pairs") {
  for (const Json& item : reference()["c"]["items"]) {
    const double t = item["t"];
    require_squares((1 - t) * pair_of(item["tau1"]) + t * pair_of(item["tau2"]), item);
  }
  const Json& corners = reference()["d"]["corners"];  // around the square: (0,0) (1,0) (1,1) (0,1)
  for (const Json& item : reference()["d"]["items"]) {
    const double u = item["u"], v = item["v"];
    require_squares((1 - u) * (1 - v) * pair_of(corners[0]) + u * (1 - v) * pair_of(corners[1]) +
                        u * v * pair_of(corners[2]) + (1 - u) * v * pair_of(corners[3]),
                    item);
  }
}

TEST_CASE("Weights of a warp, and the squares of what they sum up to") {
  for (const auto& [name, softening] : {std::pair{"e_bare", 0.0}, std::pair{"e_softened", 1.0}}) {
    const Json& given = reference()[name];
    for (const Json& item : given["items"]) {
      Generator sum;
      for (std::size_t k = 0; k < given["generators"].size(); ++k) {
        const Json& one = given["generators"][k];
        const double weight = 1 / (squared_length(triple(item["point"]) - triple(one["at"])) + softening);
        require_number(weight, item["weights"][k]);
        sum = sum + weight * pair_of(one);
      }
      require_squares(sum, item);
    }
  }
}

TEST_CASE("The generators of local curvature, split pairs and loxodromes have the squares of the table") {
  for (const Json& item : reference()["g"]["items"]) {
    const double u = item["u"], v = item["v"];
    const Generator sum = item["ku"].get<double>() * null_pair({u, 0, 0}, {0, 1, 0}) +
                          item["kv"].get<double>() * null_pair({0, 0, v}, {0, 1, 0});
    require_number(squares(sum).first, item["B_squared"]);
  }
  for (const Json& item : reference()["k"]["items"]) {
    if (item.contains("scale_about_p")) {
      const Vector p{1, 2, 3}, before = triple(item["point"]) - p, after = triple(item["exp_plus"]) - p;
      require_number(length(after) / length(before), item["scale_about_p"]);
      continue;
    }
    const double d = item["d"];
    for (const auto& [name, split] : {std::pair{"B=no^t + d (t^ni)", -d}, std::pair{"B=no^t - d (t^ni)", d}}) {
      const Generator pair = split_pair(point_of(item["position"]), triple(item["direction"]), split);
      require_number(squares(pair).first, item[name]["B_squared"]);
    }
  }
  for (const Json& item : reference()["n"]["items"]) {
    const Generator loxodrome{
        item["lambda"].get<double>() * triple(item["a"]), {}, 0, item["gamma"].get<double>() * triple(item["b"])};
    require_number(squares(loxodrome).first, item["B_squared_scalar"]);
    CHECK((kind_of(loxodrome) != GeneratorKind::general) == item["simple"].get<bool>());
  }
}

TEST_CASE("Where the product of two weighted points vanishes, and where it collapses a circle to a pole") {
  const Circle equator = circle_from({0, 0, 0}, {0, 1, 0}, 1);
  for (const Json& item : reference()["h"]["items"]) {
    if (item.contains("centre")) continue;
    const double w = item["w"], amount = item["lambda"];
    const PointProduct product = point_product({0, 1, 0}, w, {0, -1, 0}, w);
    if (amount == 0) {
      CHECK(product.scalar == 0);  // w = -1
      continue;
    }
    const Circle image = apply(versor_from(product.scalar, amount * product.generator), equator);
    const auto found = coordinates(image);
    REQUIRE(found);
    require_close(found->center, {0, amount, 0});
    // The radius is a root of a difference: half the digits.
    CHECK(found->radius < 1e-7);
  }
}

TEST_CASE("The fibers of the paper lie beside those of the Hopf fibration, and by how much") {
  for (const Json& item : reference()["i"]["items"]) {
    const double k = item["phi"].get<double>() + 0.5;
    const double radius = item["radius"], center = length(triple(item["centre"]));
    require_number(item["radius2_minus_centre2"], radius * radius - center * center);
    require_number(item["radius2_minus_centre2"], 1 - k * k / 4);
    const Json& exact = item["true_hopf_fibre_same_tilt"];
    const double exact_radius = exact["radius"], exact_center = length(triple(exact["centre"]));
    require_number(exact_radius * exact_radius - exact_center * exact_center, 1);
  }
}

TEST_CASE("The helices of the table are screws of the paper's start") {
  for (const Json& item : reference()["j"]["items"]) {
    const double turn = item["i"], slide = -2 * 3.14159265358979323846 * item["pitch"].get<double>() * turn;
    const Versor motor = screw_motor(line_from({0, 0, 0}, {0, 1, 0}), 2 * 3.14159265358979323846 * turn, slide);
    require_close(*apply(motor, Point{1, 0, 0}), point_of(item["helix_point"]));
    require_close(*apply(motor, Point{0, 2, 0}), point_of(item["generator_at"]));
  }
}

}  // namespace
