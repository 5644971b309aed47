// The reference numbers of the paper's constructions (tests/data/boosted_surfaces.json), reached through graph
// documents.

#include <catch2/catch.hpp>

#include "tests/support/close.h"
#include "tests/support/reference.h"
#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

Vector vector_of(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

Json value_at(const Json& nodes, const std::string& place) { return inspected(engine(), document(nodes), place).at(0); }

void require_near(const Json& value, const Json& expected) { require_close(vector_of(value), vector_of(expected)); }

Json pair(const Json& at, const Json& direction, const Json& split = 0) {
  return make("point_pair", {{"position", at}, {"direction", direction}, {"split", split}});
}
Json pair(const Json& item) { return pair(item["at"], item["dir"]); }

Json point(const Json& at) { return make("point", {{"position", at}}); }

Json boost(const Json& amount, const std::string& rule = "exact") {
  return make("boost",
              {{"shape", from("shape")}, {"generator", from("generator")}, {"amount", amount}, {"rule", rule}});
}

/// The image of item["point"] under exp(amount * node "generator"), by both rules.
void require_both_rules(Json nodes, const Json& item, const Json& amount) {
  nodes["shape"] = point(item["point"]);
  for (const auto& [rule, expected] : {std::pair{"exact", "exact_exp"}, {"paper", "paper_rule"}}) {
    if (!item.contains(expected)) continue;
    nodes["image"] = boost(amount, rule);
    require_near(value_at(nodes, "image"), item[expected]);
  }
}

void require_circle(const Json& value, const Json& item, bool oriented) {
  require_near(value["center"], item.contains("centre") ? item["centre"] : item["circle_centre"]);
  CHECK(value["radius"].get<double>() == Approx(item["radius"].get<double>()).epsilon(1e-12));
  const Vector normal = vector_of(item["normal_up_to_sign"]), found = vector_of(value["normal"]);
  require_close(found, (oriented || dot(found, normal) > 0 ? 1.0 : -1.0) * normal);
}

}  // namespace

TEST_CASE("Figure 1 in a graph: the boosted circle grows into a line and turns inside out") {
  for (const Json& item : reference()["a"]["items"]) {
    const Json nodes = {
        {"shape", make("circle")}, {"generator", pair({0, 0, 0}, {1, 0, 0})}, {"image", boost(item["lambda"])}};
    const Json image = value_at(nodes, "image.shape");
    if (item.contains("centre")) {
      require_circle(image, item, true);
    } else {
      CHECK(image["line"] == true);
      require_near(image["point"], {0.5, 0, 0});
      require_near(image["direction"], {0, 1, 0});
    }
  }
}

TEST_CASE("Points under one null pair in a graph") {
  for (const Json& item : reference()["b"]["items"]) {
    for (const std::string rule : {"exact", "paper"}) {
      const Json nodes = {{"shape", point(item["point"])},
                          {"generator", pair(item["tau_position"], item["tau_direction"])},
                          {"image", boost(item["k"], rule)}};
      require_near(value_at(nodes, "image"), item["result"]);
    }
  }
}

TEST_CASE("Figure 10 in a graph: blends of two null pairs") {
  for (const Json& item : reference()["c"]["items"]) {
    const Json nodes = {{"a", pair(item["tau1"])},
                        {"b", pair(item["tau2"])},
                        {"generator", make("interpolate", {{"a", from("a")}, {"b", from("b")}, {"u", item["t"]}})}};
    require_both_rules(nodes, item, item["s"]);
  }
  for (const Json& item : reference()["o"]["items"]) {
    const Json nodes = {{"a", pair({0, 0, 0}, {0, 1, 0})},
                        {"b", pair({1, 0, 0}, {0, 0, 1})},
                        {"generator", make("interpolate", {{"a", from("a")}, {"b", from("b")}, {"u", item["t"]}})},
                        {"shape", point({item["t"], 0, 0})},
                        {"image", boost(item["s"])}};
    require_near(value_at(nodes, "image"), item["exact_exp"]);
  }
}

TEST_CASE("Figure 11 in a graph: bilinear blends of four point pairs") {
  const Json& corners = reference()["d"]["corners"];  // around the square: (0,0) (1,0) (1,1) (0,1)
  Json nodes = {{"a", pair(corners[0])}, {"b", pair(corners[1])}, {"c", pair(corners[3])}, {"d", pair(corners[2])}};
  for (const Json& item : reference()["d"]["items"]) {
    nodes["generator"] = make(
        "interpolate",
        {{"a", from("a")}, {"b", from("b")}, {"c", from("c")}, {"d", from("d")}, {"u", item["u"]}, {"v", item["v"]}});
    require_both_rules(nodes, item, item["s"]);
  }
}

TEST_CASE("Figure 9 in a graph: warps by several point pairs, with both weights, rules and methods") {
  const auto warped = [](const Json& generators, const Json& item, double softening, const std::string& rule,
                         const std::string& method) {
    Json nodes = {{"p", point(item["point"])}};
    Json links = Json::array();
    for (const Json& generator : generators) {
      const std::string id = "g" + std::to_string(links.size());
      nodes[id] = pair(generator);
      links.push_back(from(id));
    }
    nodes["image"] = make("warp", {{"shape", from("p")},
                                   {"generators", links},
                                   {"strength", item["s"]},
                                   {"softening", softening},
                                   {"rule", rule},
                                   {"method", method}});
    return value_at(nodes, "image");
  };
  for (const auto& [name, softening] : {std::pair{"e_bare", 0.0}, {"e_softened", 1.0}}) {
    for (const Json& item : reference()[name]["items"]) {
      const Json& generators = reference()[name]["generators"];
      require_near(warped(generators, item, softening, "exact", "sum_generators"), item["exact_exp"]);
      require_near(warped(generators, item, softening, "paper", "sum_generators"), item["paper_rule"]);
    }
  }
  for (const Json& item : reference()["l"]["items"]) {
    const Json& generators = reference()["l"]["generators"];
    require_near(warped(generators, item, 0, "exact", "sum_generators"), item["exact_exp"]);
    require_near(warped(generators, item, 0, "paper", "sum_generators"), item["sum_then_one_rotor"]);
    require_near(warped(generators, item, 0, "exact", "sum_displacements"), item["sum_of_displacements"]);
    require_near(warped(generators, item, 0, "paper", "sum_displacements"), item["sum_of_displacements"]);
  }
}

TEST_CASE("Figure 13 in a graph: a line bends to a circle of the given curvature") {
  for (const Json& item : reference()["f"]["items"]) {
    const Json nodes = {{"shape", make("line", {{"point", {1, 2, 3}}, {"direction", {0, 0, 1}}})},
                        {"generator", pair({1, 2, 3}, {1, 0, 0})},
                        {"image", boost(-0.5 * item["kappa"].get<double>())}};
    require_circle(value_at(nodes, "image"), item, true);
  }
}

TEST_CASE("Figure 14 in a graph: local curvature from two point pairs") {
  for (const Json& item : reference()["g"]["items"]) {
    for (const std::string rule : {"exact", "paper"}) {
      const Json nodes = {
          {"u", pair({item["u"], 0, 0}, {0, 1, 0})},
          {"v", pair({0, 0, item["v"]}, {0, 1, 0})},
          {"generator", make("add", {{"generators", {from("u"), from("v")}}, {"weights", {item["ku"], item["kv"]}}})},
          {"shape", point(item["point"])},
          {"image", boost(item["s"], rule)}};
      require_near(value_at(nodes, "image"), item["result"]);
    }
  }
}

TEST_CASE("Figures 6 and 7 in a graph: fibers by boost and twist between lines") {
  for (const Json& item : reference()["i"]["items"]) {
    const double k = item["phi"].get<double>() + 0.5;
    const Json nodes = {
        {"shape", make("circle", {{"normal", {0, 1, 0}}})},
        {"pole", make("line", {{"direction", {0, -1, 0}}})},
        {"x", make("expression", {{"formula", "cos(pi * x)"}, {"x", item["theta"]}})},
        {"z", make("expression", {{"formula", "sin(pi * x)"}, {"x", item["theta"]}})},
        {"outward", make("vector", {{"x", from("x")}, {"z", from("z")}})},
        {"generator", make("point_pair", {{"direction", from("outward")}})},
        {"limit", boost(1)},
        {"boosted", boost(k)},
        {"image", make("twist_between",
                       {{"shape", from("boosted")}, {"from", from("limit")}, {"to", from("pole")}, {"amount", k}})}};
    require_circle(value_at(nodes, "image"), item, false);
  }
}

TEST_CASE("Figure 7 in a graph: the true fibers of the same tilt") {
  for (const Json& item : reference()["i"]["items"]) {
    const Json& exact = item["true_hopf_fibre_same_tilt"];
    if (!exact.contains("centre")) continue;
    const double k = item["phi"].get<double>() + 0.5;
    // The node counts theta from a direction of its own, so lengths are compared, and the tilt.
    const Json nodes = {{"shape", make("circle", {{"normal", {0, 1, 0}}})},
                        {"image", make("hopf", {{"shape", from("shape")}, {"latitude", k}, {"theta", item["theta"]}})}};
    const Json fiber = value_at(nodes, "image");
    const double radius = exact["radius"];
    CHECK(fiber["radius"].get<double>() == Approx(radius).epsilon(1e-12));
    CHECK(length(vector_of(fiber["center"])) ==
          Approx(length(vector_of(exact["centre"]))).epsilon(1e-12).margin(1e-12));
    CHECK(std::abs(vector_of(fiber["normal"]).y) ==
          Approx(std::abs(vector_of(exact["normal_up_to_sign"]).y)).epsilon(1e-12));
  }
}

TEST_CASE("Figure 16 in a graph: products of weighted points carry the equator, collapse it, or vanish") {
  for (const Json& item : reference()["h"]["items"]) {
    const Json nodes = {{"shape", make("circle", {{"normal", {0, 1, 0}}})},
                        {"image", make("product", {{"shape", from("shape")},
                                                   {"a", {0, 1, 0}},
                                                   {"b", {0, -1, 0}},
                                                   {"weight_a", item["w"]},
                                                   {"weight_b", item["w"]},
                                                   {"amount", item["lambda"]}})}};
    if (item.contains("centre")) {
      require_circle(value_at(nodes, "image"), item, false);
    } else if (item["w"] == -1) {
      const auto refused = engine().inspect({.graph = engine().read(document(nodes)),
                                             .parameters = Json::object(),
                                             .node = "image",
                                             .output = "",
                                             .full = false},
                                            Job());
      REQUIRE_FALSE(refused);
      CHECK(refused.problems().front().code == "degenerate");
    } else {
      const Json point = value_at(nodes, "image");
      require_near(point["center"], {0, item["lambda"], 0});
      CHECK(point["radius"].get<double>() < 1e-7);  // a root of a difference: half the digits
    }
  }
}

TEST_CASE("Figures 4 and 5 in a graph: boosted helices") {
  for (const Json& item : reference()["j"]["items"]) {
    const Json nodes = {{"shape", point(item["helix_point"])},
                        {"generator", pair(item["generator_at"], item["generator_dir_times_j"])},
                        {"image", boost(1)}};
    require_near(value_at(nodes, "image"), item["result"]);
  }
}

TEST_CASE("Figure 8 in a graph: flat points and split pairs") {
  for (const Json& item : reference()["k"]["items"]) {
    Json nodes = {{"shape", point(item["point"])}};
    if (item.contains("exp_plus")) {
      nodes["generator"] = make("flat_point", {{"position", {1, 2, 3}}});
      nodes["image"] = boost(-0.5);
      require_near(value_at(nodes, "image"), item["exp_plus"]);
      continue;
    }
    for (const auto& [name, sign] : {std::pair{"B=no^t + d (t^ni)", -1.0}, {"B=no^t - d (t^ni)", 1.0}}) {
      nodes["generator"] = pair(item["position"], item["direction"], sign * item["d"].get<double>());
      nodes["image"] = boost(item["s"]);
      require_near(value_at(nodes, "image"), item[name]["result"]);
    }
  }
}

TEST_CASE("Figure 3 in a graph: loxodromes") {
  for (const Json& item : reference()["n"]["items"]) {
    const Json nodes = {{"a", pair({0, 0, 0}, item["a"])},
                        {"b", make("direction", {{"direction", item["b"]}})},
                        {"generator", make("add", {{"generators", {from("a"), from("b")}},
                                                   {"weights", {item["lambda"], item["gamma"]}}})}};
    require_both_rules(nodes, item, 1);
  }
}

TEST_CASE("Eq. 11 in a graph: powers of the twist between two lines") {
  const auto line = [](Json at, Json direction) {
    return make("line", {{"point", std::move(at)}, {"direction", std::move(direction)}});
  };
  for (const Json& item : reference()["m"]["items"]) {
    const std::string name = item["case"];
    Json nodes = {
        {"p", point(item["point"])}, {"from", line({0.5, 0, 0}, {0, 1, 0})}, {"to", line({0, 0, 0}, {0, 0, 1})}};
    if (name.starts_with("motor2")) {
      nodes["from"] = line({1, 2, 3}, {1, 1, 0});
      nodes["to"] = line({-1, 0, 0.5}, {0.2, -1, 0.7});
    } else if (name.starts_with("motor_p")) {
      nodes["from"] = line({0, 0, 0}, {0, 0, 1});
      nodes["to"] = line({2, 0, 0}, {0, 0, 1});
    }
    nodes["image"] = make("twist_between", {{"shape", from("p")},
                                            {"from", from("from")},
                                            {"to", from("to")},
                                            {"amount", std::stod(name.substr(name.find(' ')))}});
    require_near(value_at(nodes, "image"), item["result"]);
  }
}
