// Reference numbers for the constructions of "Boosted Surfaces", computed independently with 40 digits
// (tests/data/boosted_surfaces.json).

#include <catch2/catch.hpp>

#include "algebra/construct.h"
#include "algebra/elementary.h"
#include "algebra/extract.h"
#include "algebra/kernels.h"
#include "algebra/versor.h"
#include "geometry/angle.h"
#include "geometry/json.h"
#include "tests/algebra/reference_elements.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

Point transformed(const Generator& generator, Rule rule, const Json& point) {
  return *apply(exponential(generator, rule), point_of(point));
}

void require_both_rules(const Generator& generator, const Json& item) {
  require_close(transformed(generator, Rule::exact, item["point"]), point_of(item["exact_exp"]));
  if (item.contains("paper_rule"))
    require_close(transformed(generator, Rule::paper, item["point"]), point_of(item["paper_rule"]));
}

void require_circle(const Circle& circle, const Json& item, bool oriented) {
  const auto found = coordinates(circle);
  REQUIRE(found);
  REQUIRE_FALSE(found->line);
  require_close(found->center, point_of(item.contains("centre") ? item["centre"] : item["circle_centre"]));
  REQUIRE(found->radius == Approx(item["radius"].get<double>()).epsilon(1e-12));
  const Vector normal = triple(item["normal_up_to_sign"]);
  const double sign = oriented || dot(found->normal, normal) > 0 ? 1 : -1;
  require_close(found->normal, sign * normal);
}

TEST_CASE("Figure 1: the boosted circle grows into a line and turns inside out") {
  const Circle circle = circle_from({0, 0, 0}, {0, 0, 1}, 1);
  for (const Json& item : reference()["a"]["items"]) {
    const double amount = item["lambda"];
    const Circle image = apply(exponential(amount * null_pair({0, 0, 0}, {1, 0, 0})), circle);
    if (item.contains("centre")) {
      require_circle(image, item, true);
      continue;
    }
    const auto line = coordinates(image);
    REQUIRE(line);
    REQUIRE(line->line);
    require_close(line->point, {0.5, 0, 0});
    require_close(line->direction, {0, 1, 0});
  }
}

TEST_CASE("Figure 1: the boosted circle becomes a line to round-off anywhere in space") {
  for (const Point& center : {Point{0, 0, 0}, Point{1, 2, 3}, Point{-30, 10, 20}}) {
    for (const double radius : {0.5, 1.0, 7.0, 1.0 / 3}) {
      const Vector tangent = (1 / radius) * normalized({1, 1, 0});
      const auto line =
          coordinates(apply(exponential(null_pair(center, tangent)), circle_from(center, {1, -1, 3}, radius)));
      REQUIRE(line);
      REQUIRE(line->line);
    }
  }
}

TEST_CASE("Points under one null generator") {
  for (const Json& item : reference()["b"]["items"]) {
    const Generator tau = null_pair(point_of(item["tau_position"]), triple(item["tau_direction"]));
    for (const Rule rule : {Rule::exact, Rule::paper}) {
      require_close(transformed(item["k"].get<double>() * tau, rule, item["point"]), point_of(item["result"]));
    }
  }
}

TEST_CASE("Figure 10: blends of two null generators") {
  for (const Json& item : reference()["c"]["items"]) {
    const double t = item["t"], s = item["s"];
    require_both_rules(s * ((1 - t) * pair_of(item["tau1"]) + t * pair_of(item["tau2"])), item);
  }
  for (const Json& item : reference()["o"]["items"]) {
    const double t = item["t"], s = item["s"];
    const Generator blend = (1 - t) * null_pair({0, 0, 0}, {0, 1, 0}) + t * null_pair({1, 0, 0}, {0, 0, 1});
    require_close(*apply(exponential(s * blend), Point{t, 0, 0}), point_of(item["exact_exp"]));
  }
}

TEST_CASE("Figure 11: bilinear blends of four generators") {
  const Json& corners = reference()["d"]["corners"];
  const Generator a = pair_of(corners[0]), b = pair_of(corners[1]), d = pair_of(corners[2]), c = pair_of(corners[3]);
  for (const Json& item : reference()["d"]["items"]) {
    const double u = item["u"], v = item["v"], s = item["s"];
    require_both_rules(s * ((1 - u) * (1 - v) * a + u * (1 - v) * b + (1 - u) * v * c + u * v * d), item);
  }
}

TEST_CASE("Figure 9: the same generators as warps, both weights") {
  for (const auto& [name, softening] : {std::pair{"e_bare", 0.0}, std::pair{"e_softened", 1.0}}) {
    const Json& given = reference()[name];
    std::vector<kernels::WarpSource> sources;
    for (const Json& g : given["generators"]) sources.push_back({pair_of(g), point_of(g["at"])});
    for (const Json& item : given["items"]) {
      for (const Rule rule : {Rule::exact, Rule::paper}) {
        const kernels::WarpSettings settings{item["s"], 2, softening, rule, kernels::WarpMethod::sum_generators};
        Point p = point_of(item["point"]);
        kernels::warp_points(kernels::WarpField(sources), settings, {&p.x, &p.y, &p.z}, {&p.x, &p.y, &p.z}, 1);
        require_close(p, point_of(item[rule == Rule::exact ? "exact_exp" : "paper_rule"]));
      }
    }
  }
}

TEST_CASE("Figure 9: one rotor of the sum and the sum of displacements") {
  using kernels::WarpMethod;
  std::vector<kernels::WarpSource> sources;
  for (const Json& g : reference()["l"]["generators"]) sources.push_back({pair_of(g), point_of(g["at"])});
  for (const Json& item : reference()["l"]["items"]) {
    const auto warped = [&](Rule rule, WarpMethod method) {
      Point p = point_of(item["point"]);
      kernels::warp_points(kernels::WarpField(sources), {item["s"], 2, 0, rule, method}, {&p.x, &p.y, &p.z},
                           {&p.x, &p.y, &p.z}, 1);
      return p;
    };
    require_close(warped(Rule::paper, WarpMethod::sum_generators), point_of(item["sum_then_one_rotor"]));
    require_close(warped(Rule::exact, WarpMethod::sum_generators), point_of(item["exact_exp"]));
    require_close(warped(Rule::exact, WarpMethod::sum_displacements), point_of(item["sum_of_displacements"]));
    require_close(warped(Rule::paper, WarpMethod::sum_displacements), point_of(item["sum_of_displacements"]));
  }
}

TEST_CASE("Figure 13, eq. 17: a line bends to a circle of the given curvature") {
  for (const Json& item : reference()["f"]["items"]) {
    const double curvature = item["kappa"];
    const Versor bend = versor_from(1, -0.5 * curvature * null_pair({1, 2, 3}, {1, 0, 0}));
    require_circle(apply(bend, line_from({1, 2, 3}, {0, 0, 1})), item, true);
  }
}

TEST_CASE("Figure 14, eq. 18: local curvature from two generators") {
  for (const Json& item : reference()["g"]["items"]) {
    const double u = item["u"], v = item["v"], ku = item["ku"], kv = item["kv"], s = item["s"];
    const Generator sum = ku * null_pair({u, 0, 0}, {0, 1, 0}) + kv * null_pair({0, 0, v}, {0, 1, 0});
    for (const Rule rule : {Rule::exact, Rule::paper}) {
      require_close(transformed(s * sum, rule, item["point"]), point_of(item["result"]));
    }
  }
}

TEST_CASE("Figure 16, eq. 20: products of weighted points carry the equator") {
  const Circle equator = circle_from({0, 0, 0}, {0, 1, 0}, 1);
  for (const Json& item : reference()["h"]["items"]) {
    if (!item.contains("centre")) continue;
    const double w = item["w"], amount = item["lambda"];
    const PointProduct product = point_product({0, 1, 0}, w, {0, -1, 0}, w);
    REQUIRE(product.scalar == Approx(-(1 + w)));
    require_circle(apply(versor_from(product.scalar, amount * product.generator), equator), item, false);
  }
}

TEST_CASE("Figures 6, 7: fibers by boost and motor") {
  const Circle base = circle_from({0, 0, 0}, {0, 1, 0}, 1), pole = line_from({0, 0, 0}, {0, -1, 0});
  for (const Json& item : reference()["i"]["items"]) {
    const double theta = item["theta"], k = item["phi"].get<double>() + 0.5;
    const auto [sine, cosine] = elementary::sincos(pi * theta);
    const Generator pair = null_pair({0, 0, 0}, {cosine, 0, sine});
    const Circle limit = apply(exponential(pair), base);
    auto motor = motor_between(limit, pole);
    REQUIRE(motor);
    const auto logarithm = motor_logarithm(*motor);
    REQUIRE(logarithm);
    require_circle(apply(exponential(k * *logarithm), apply(exponential(k * pair), base)), item, false);
  }
}

TEST_CASE("Figures 4, 5: boosted helices") {
  for (const Json& item : reference()["j"]["items"]) {
    const Generator pair = null_pair(point_of(item["generator_at"]), triple(item["generator_dir_times_j"]));
    require_close(transformed(pair, Rule::exact, item["helix_point"]), point_of(item["result"]));
  }
}

TEST_CASE("Figure 8: flat points and split pairs") {
  for (const Json& item : reference()["k"]["items"]) {
    if (item.contains("exp_plus")) {
      require_close(transformed(-0.5 * flat_point({1, 2, 3}), Rule::exact, item["point"]), point_of(item["exp_plus"]));
      continue;
    }
    const double d = item["d"], s = item["s"];
    for (const auto& [name, split] : {std::pair{"B=no^t + d (t^ni)", -d}, std::pair{"B=no^t - d (t^ni)", d}}) {
      const Generator pair = split_pair(point_of(item["position"]), triple(item["direction"]), split);
      for (const Rule rule : {Rule::exact, Rule::paper}) {
        require_close(transformed(s * pair, rule, item["point"]), point_of(item[name]["result"]));
      }
    }
  }
}

TEST_CASE("Figure 3: loxodromes") {
  for (const Json& item : reference()["n"]["items"]) {
    require_both_rules(
        {item["lambda"].get<double>() * triple(item["a"]), {}, 0, item["gamma"].get<double>() * triple(item["b"])},
        item);
  }
}

TEST_CASE("Eq. 11: powers of the motor between two lines") {
  const auto motor = motor_between(line_from({0.5, 0, 0}, {0, 1, 0}), line_from({0, 0, 0}, {0, 0, 1}));
  const auto skew = motor_between(line_from({1, 2, 3}, {1, 1, 0}), line_from({-1, 0, 0.5}, {0.2, -1, 0.7}));
  const auto parallel = motor_between(line_from({0, 0, 0}, {0, 0, 1}), line_from({2, 0, 0}, {0, 0, 1}));
  for (const Json& item : reference()["m"]["items"]) {
    const std::string name = item["case"];
    const double power = std::stod(name.substr(name.find(' ')));
    const Versor& used = name.starts_with("motor2") ? *skew : name.starts_with("motor_p") ? *parallel : *motor;
    require_close(*apply(exponential(power * *motor_logarithm(used)), point_of(item["point"])),
                  point_of(item["result"]));
  }
}

}  // namespace
