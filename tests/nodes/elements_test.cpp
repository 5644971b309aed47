// Elements through the JSON that `inspect` answers.

#include <catch2/catch.hpp>
#include <cmath>

#include "algebra/construct.h"
#include "algebra/versor.h"
#include "tests/nodes/singular.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"
#include "tests/support/triple.h"

using namespace dini;
using namespace dini::support;

namespace {

Json only(const std::string& type, Json inputs, const std::string& output = "") {
  CatalogueGraph graph = graph_of({{"n", make(type, std::move(inputs))}});
  return graph.json(output.empty() ? "n" : "n." + output)["values"].at(0);
}

}  // namespace

TEST_CASE("Numbers, vectors and points are shown as they were given, to the last bit") {
  CHECK(only("number", {{"value", 0.1}}).dump() == "0.1");
  CHECK(only("vector", {{"x", 0.1}, {"y", -2}, {"z", 1e-300}}) == Json{0.1, -2.0, 1e-300});
  CHECK(only("point", {{"position", {1, 2, 1.0 / 3}}}) == Json{1.0, 2.0, 1.0 / 3});
  CatalogueGraph graph = graph_of({{"n", make("number")}});
  CHECK(graph.json("n") == Json{{"type", "number"}, {"axes", Json::array()}, {"values", {0.0}}});
}

TEST_CASE("A circle is shown by center, radius and unit normal, a line by point and direction") {
  const Json circle = only("circle", {{"center", {1, -2, 0.5}}, {"normal", {0, 3, 4}}, {"radius", 2.5}});
  CHECK(circle.size() == 3);
  require_close(triple(circle["center"]), {1, -2, 0.5});
  require_close(triple(circle["normal"]), {0, 0.6, 0.8});
  CHECK(circle["radius"].get<double>() == Approx(2.5).epsilon(1e-14));
  const Json line = only("line", {{"point", {1, 5, 2}}, {"direction", {0, -2, 0}}});
  CHECK(line.size() == 3);
  CHECK(line["line"] == true);
  require_close(triple(line["point"]), {1, 0, 2});
  require_close(triple(line["direction"]), {0, -1, 0});
}

TEST_CASE("Circles without a normal, lines without a direction and turns about a circle are degenerate") {
  require_degenerate({{"n", make("circle", {{"normal", {0, 0, 0}}})}}, "normal");
  require_degenerate({{"n", make("line", {{"direction", {0, 0, 0}}})}}, "direction");
  require_degenerate({{"c", make("circle")}, {"n", make("rotation", {{"axis", from("c")}})}}, "axis");
}

TEST_CASE("A radius that its distance from the origin drowns is an error, never another radius") {
  for (const char* type : {"circle", "sphere"}) {
    for (const double distance : {1e3, 1e6, 1e9, 1e12, 1e17, 1e200}) {
      for (const double share : {1e-9, 1e-7, 1e-6, 1e-5, 1e-3}) {
        const double radius = share * distance;
        if (radius > 1e9) continue;
        CatalogueGraph graph = graph_of({{"n", make(type, {{"center", {distance, 0, 0}}, {"radius", radius}})}});
        CAPTURE(type, distance, radius);
        if (const Problems problems = graph.problems("n"); !problems.empty()) {
          CHECK(codes(problems) == std::multiset<std::string>{"out-of-range n.center"});
          CHECK(share < 1e-6);
        } else {
          CHECK(share > 1e-7);
          CHECK(graph.json("n")["values"][0]["radius"].get<double>() == Approx(radius).epsilon(1e-3));
        }
      }
    }
    // A point circle is one on purpose.
    CHECK(only(type, {{"center", {1e9, 0, 0}}, {"radius", 0}})["radius"] == 0.0);
    CatalogueGraph moved = graph_of({{"n", make(type)},
                                     {"away", make("translate", {{"shape", from("n")}, {"vector", {1e12, 0, 0}}})},
                                     {"near", make("translate", {{"shape", from("n")}, {"vector", {1, 0, 0}}})}});
    moved.json("near");
    CHECK(moved.warnings().empty());
    moved.json("away");
    REQUIRE(moved.warnings().size() == 1);
    CHECK(moved.warnings()[0].code == "degenerate");
  }
}

TEST_CASE("Axes have names that can be shown, and no two of a node the same") {
  const auto problems = [](const Json& inputs) {
    return codes(graph_of({{"n", make("grid", inputs)}}).static_problems());
  };
  CHECK(problems({{"axis_u", "rows and\tcolumns"}}) == std::multiset<std::string>{"out-of-range n.axis_u"});
  CHECK(problems({{"axis_u", std::string(65, 'k')}}) == std::multiset<std::string>{"out-of-range n.axis_u"});
  CHECK(problems({{"axis_v", ""}}) == std::multiset<std::string>{"out-of-range n.axis_v"});
  CHECK(problems({{"axis_v", "u"}}) == std::multiset<std::string>{"axis-mismatch n.axis_v"});
  CHECK(problems({{"axis_u", "rows of k"}, {"axis_v", "\u00fc"}}).empty());
  const Json twice = {{"k", make("range", {{"axis", "rows"}})},
                      {"c", make("circle", {{"radius", from("k")}})},
                      {"n", make("sample", {{"shape", from("c")}, {"axis", "rows"}})}};
  CHECK(codes(graph_of(twice).static_problems()) == std::multiset<std::string>{"axis-mismatch n.axis"});
}

TEST_CASE("A point pair is shown by the coefficients of its formula") {
  // T(c, t) = no^t + (c.t) no^ni + c^t + ((c.t) c - c^2/2 t)^ni, less split t^ni.
  const Vector c = {0.5, -1, 2}, t = {0.25, 3, -0.5};
  for (const double split : {0.0, 0.75, -0.5}) {
    const Json pair =
        only("point_pair", {{"position", {0.5, -1, 2}}, {"direction", {0.25, 3, -0.5}}, {"split", split}});
    CHECK(pair.size() == 4);
    require_close(triple(pair["no_e"]), t);
    require_close(triple(pair["e_e"]), cross(c, t));
    CHECK(pair["no_ni"].get<double>() == Approx(dot(c, t)).epsilon(1e-14));
    require_close(triple(pair["e_ni"]), dot(c, t) * c - (dot(c, c) / 2) * t - split * t);
  }
}

TEST_CASE("The split of a point pair decides the sign of its square") {
  // B^2 = 2 split |t|^2 for these simple bivectors: (no_ni)^2 - |e_e|^2 - 2 no_e . e_ni.
  for (const double split : {-1.5, -0.01, 0.0, 0.01, 0.8}) {
    CatalogueGraph graph = graph_of(
        {{"n", make("point_pair", {{"position", {0.3, 1, -2}}, {"direction", {1, -0.5, 2}}, {"split", split}})}});
    const auto b = graph.one<Generator>("n");
    const double square = b.no_ni * b.no_ni - dot(b.e_e, b.e_e) - 2 * dot(b.no_e, b.e_ni);
    CHECK(square == Approx(2 * split * 5.25).margin(1e-12));
  }
}

TEST_CASE("A point pair through two points has the scalar and the bivector of their product") {
  CatalogueGraph graph = graph_of(
      {{"n", make("point_pair_through", {{"a", {0, 0, 1}}, {"weight_a", 0.5}, {"b", {1, 0, -1}}, {"weight_b", 2}})}});
  const PointProduct product = point_product({0, 0, 1}, 0.5, {1, 0, -1}, 2);
  CHECK(graph.one<Generator>("n.generator") == product.generator);
  CHECK(graph.one<double>("n.scalar") == product.scalar);
  // Twice the scalar part of two unit points is less their squared distance.
  CatalogueGraph unit = graph_of({{"n", make("point_pair_through", {{"a", {1, 2, 3}}, {"b", {1, 2, 5}}})}});
  CHECK(unit.one<double>("n.scalar") == Approx(-2));
}

TEST_CASE("Flat points scale, directions move and rotations turn, by what their pages say") {
  CatalogueGraph graph = graph_of(
      {{"p", make("point", {{"position", {2, 1, 0}}})},
       {"axis", make("line", {{"point", {1, 0, 0}}, {"direction", {0, 0, 5}}})},
       {"flat", make("flat_point", {{"position", {1, 1, 0}}})},
       {"move", make("direction", {{"direction", {0, 0.5, 2}}})},
       {"turn", make("rotation", {{"axis", from("axis")}})},
       {"scaled", make("transform", {{"shape", from("p")}, {"generator", from("flat")}, {"amount", 0.25}})},
       {"moved", make("transform", {{"shape", from("p")}, {"generator", from("move")}, {"amount", -0.75}})},
       {"turned",
        make("transform", {{"shape", from("p")}, {"generator", from("turn")}, {"amount", -0.7853981633974483}})}});
  require_close(graph.one<Point>("scaled"), Point{1 + std::exp(0.5), 1, 0});
  require_close(graph.one<Point>("moved"), Point{2, 1.75, 3});
  require_close(graph.one<Point>("turned"), Point{0, 1, 0});
}
