// What every node does with points, lines and generators that stand where no usual answer is. One test for each kind,
// one entry for each node whose card says something about it.

#include "tests/nodes/singular.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A turn about the z axis and as fast a turn about the unit circle around it.
const Json isoclinic = {
    {"z", make("line")},
    {"turn", make("rotation", {{"axis", from("z")}})},
    {"roll", make("point_pair", {{"split", -0.5}})},
    {"both", make("add", {{"generators", {from("turn"), from("roll")}}})},
    {"spot", spot},
    {"turned", make("transform", {{"shape", from("spot")}, {"generator", from("turn")}, {"amount", 0.7}})},
    {"wanted", make("transform", {{"shape", from("turned")}, {"generator", from("roll")}, {"amount", 0.7}})}};

}  // namespace

TEST_CASE("Singular inputs: a point at a generator") {
  const Json tau = {{"tau", make("point_pair", {{"position", {1, 2, 3}}})},
                    {"far", make("point_pair", {{"position", {0, 0, 1}}})},
                    {"real", make("point_pair", {{"position", {1, 2, 3}}, {"split", 0.5}})},
                    {"at", make("point", {{"position", {1, 2, 3}}})},
                    {"pole", make("point", {{"position", {1, 2, 4}}})}};
  const auto stays = [&](const char* type) {
    return [&, type] {
      require_close(point(with(type, {{"shape", from("at")}, {"generator", from("tau")}, {"amount", 7}}, tau)),
                    {1, 2, 3});
      require_close(point(with(type, {{"shape", from("pole")}, {"generator", from("real")}, {"amount", 7}}, tau)),
                    {1, 2, 4});
    };
  };
  hold("point at a generator",
       {{"boost", stays("boost")},
        {"transform", stays("transform")},
        {"warp",
         [&] {
           Json inputs = {{"shape", from("at")}, {"generators", {from("tau"), from("far")}}};
           CHECK(point(with("warp", inputs, tau)) == Point{1, 2, 3});
           inputs["rule"] = "paper";
           CHECK(point(with("warp", inputs, tau)) == Point{1, 2, 3});
           inputs["method"] = "sum_displacements";
           const Point both = point(with("warp", inputs, tau));
           inputs["generators"] = {from("far")};
           require_close(both, point(with("warp", inputs, tau)));
         }},
        {"orbit",
         [&] {
           const Json nodes = with("orbit", {{"point", {1, 2, 3}}, {"generator", from("tau")}, {"to", 5}}, tau);
           for (const Point& p : graph_of(nodes).all<Point>("n")) require_close(p, {1, 2, 3});
         }},
        {"flow",
         [&] {
           const Json nodes = with("flow", {{"point", {1, 2, 3}}, {"generator", from("tau")}}, tau);
           for (const char* place : {"n.velocity", "n.acceleration"}) {
             CHECK(length(graph_of(nodes).one<Vector>(place)) == 0);
           }
           for (const char* place : {"n.curvature", "n.torsion"}) CHECK(value(nodes, place) == 0);
         }},
        {"contour",
         [&] {
           const Json nodes = with("contour", {{"point", {1, 2, 3}}, {"generators", {from("tau")}}}, tau);
           for (const Point& p : graph_of(nodes).all<Point>("n")) CHECK(p == Point{1, 2, 3});
         }},
        {"patch", [] {
           const Json corners = {{"a", make("point_pair", {{"position", {-1, -1, 0}}})},
                                 {"b", make("point_pair", {{"position", {1, -1, 0}}})},
                                 {"c", make("point_pair", {{"position", {-1, 1, 0}}})},
                                 {"d", make("point_pair", {{"position", {1, 1, 0}}})}};
           CatalogueGraph graph = graph_of(with(
               "patch",
               {{"a", from("a")}, {"b", from("b")}, {"c", from("c")}, {"d", from("d")}, {"count_u", 5}, {"count_v", 5}},
               corners));
           const SharedMesh mesh = graph.one<SharedMesh>("n");
           for (const Point& corner : {Point{-1, -1, 0}, Point{1, -1, 0}, Point{-1, 1, 0}, Point{1, 1, 0}}) {
             double nearest = 1e300;
             for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
               nearest = std::min(nearest, distance(mesh->positions[i], corner));
             }
             CHECK(nearest < 1e-12);
           }
         }}});
}

TEST_CASE("Singular inputs: coincident points") {
  const Json at = {1, 2, 3};
  const Json others = {{"spot", spot}, {"same", make("list", {{"items", {at, at, at}}})}};
  hold("coincident points",
       {{"circle_through",
         [&] {
           require_degenerate(with("circle_through", {{"a", at}, {"b", at}}), "b");
         }},
        {"sphere_through",
         [&] {
           require_degenerate(with("sphere_through", {{"a", at}, {"b", at}}), "d");
           require_degenerate(with("sphere_through", {{"d", {0, -1, 0}}}), "d");
         }},
        {"array_along",
         [&] {
           const Json nodes = with("array_along", {{"shape", from("spot")}, {"curve", from("same")}}, others);
           for (const Point& p : graph_of(nodes).all<Point>("n")) require_close(p, {2, 2.5, 3.25});
         }},
        {"curve",
         [&] {
           for (const Point& p : graph_of(with("curve", {{"points", from("same")}}, others)).all<Point>("n")) {
             CHECK(p == Point{1, 2, 3});
           }
         }},
        {"evolve",
         [&] {
           for (const Point& p :
                graph_of(with("evolve", {{"points", from("same")}, {"softening", 0}}, others)).all<Point>("n")) {
             CHECK(p == Point{1, 2, 3});
           }
         }},
        {"point_pair_through",
         [&] {
           for (const double weight : {1.0, -1.0, 0.5}) {
             const Json nodes =
                 with("point_pair_through", {{"a", at}, {"b", at}, {"weight_a", weight}, {"weight_b", weight}});
             CHECK(graph_of(nodes).one<Generator>("n") == Generator{});
             CHECK(value(nodes, "n.scalar").get<double>() == Approx(14 * (1 - weight)));
           }
         }},
        {"product",
         [&] {
           require_degenerate(with("product", {{"shape", from("spot")}, {"a", at}, {"b", at}}, others), "amount");
         }},
        {"surface",
         [&] {
           const Json sheet = {{"g", make("grid", {{"u_vector", {0, 0, 0}}, {"count_u", 4}, {"count_v", 4}})}};
           CHECK(triangles(with("surface", {{"shape", from("g.points")}}, sheet)) == 0);
         }},
        {"tube",
         [&] {
           CHECK(triangles(with("tube", {{"shape", from("same")}}, others)) == 0);
           const Json stutter = {
               {"p", make("list", {{"items", {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}}})}};
           const Json plain = {{"p", make("list", {{"items", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}})}};
           CHECK(triangles(with("tube", {{"shape", from("p")}}, stutter)) ==
                 triangles(with("tube", {{"shape", from("p")}}, plain)));
         }},
        {"warp", [&] {
           const Json pairs = {{"spot", spot},
                               {"a", make("point_pair", {{"position", at}, {"direction", {1, 0, 0}}})},
                               {"b", make("point_pair", {{"position", at}, {"direction", {0, 1, 0}}})},
                               {"sum", make("point_pair", {{"position", at}, {"direction", {1, 1, 0}}})}};
           const auto warped = [&](const Json& generators) {
             return point(with("warp", {{"shape", from("spot")}, {"generators", generators}}, pairs));
           };
           require_close(warped({from("a"), from("b")}), warped(Json::array({from("sum")})));
         }}});
}

TEST_CASE("Singular inputs: both weights -1") {
  const Json poles = {{"a", {0, 0, 1}}, {"b", {0, 0, -1}}, {"weight_a", -1}, {"weight_b", -1}};
  hold("w = -1",
       {{"point_pair_through",
         [&] {
           const Json nodes = {{"n", make("point_pair_through", poles)}};
           CHECK(value(nodes, "n.scalar") == 0);
           CHECK_FALSE(graph_of(nodes).one<Generator>("n") == Generator{});
         }},
        {"evolve",
         [] {
           const auto way = [](double weight) {
             const Json ends = {{"ends", make("list", {{"items", {{0, 0, -1}, {0, 0, 1}}}})}};
             const Json nodes = with(
                 "evolve", {{"points", from("ends")}, {"weights", weight}, {"steps", 2}, {"strength", 1e-4}}, ends);
             return graph_of(nodes).all<Point>("n")[2].z + 1;
           };
           CHECK(way(-1) > 0);
           CHECK(way(-1) == Approx(2 * way(0)).epsilon(1e-3));
         }},
        {"product", [&] {
           const auto image = [&](double amount) {
             return with("product", plus(poles, {{"shape", from("spot")}, {"amount", amount}}), {{"spot", spot}});
           };
           require_close(point(image(0.2)), point(image(-3)));
           require_degenerate(image(0), "amount");
         }}});
}

TEST_CASE("Singular inputs: parallel and opposite lines") {
  const auto line = [](Json at, Json along) {
    return make("line", {{"point", std::move(at)}, {"direction", std::move(along)}});
  };
  const auto plane = [](double height, double up) {
    return make("osculating_sphere", {{"position", {0, 0, height}}, {"normal", {0, 0, up}}, {"curvature", 0}});
  };
  const auto carried = [&](const char* type, const Json& first, const Json& second, double amount) {
    return point(with(type, {{"shape", from("spot")}, {"from", from("a")}, {"to", from("b")}, {"amount", amount}},
                      {{"spot", spot}, {"a", first}, {"b", second}}));
  };
  const auto seen = [](const char* type, const char* first, const char* second, const Json& a, const Json& b,
                       const char* place = "n") {
    return value(with(type, {{first, from("a")}, {second, from("b")}}, {{"a", a}, {"b", b}}), place);
  };
  hold("parallel lines", {{"meet",
                           [&] {
                             const Json other = plane(2, 1), along = line({0, 0, 1}, {1, 0, 0});
                             for (const Json& shape : {plane(0, -1), along}) {
                               CHECK(seen("meet", "shape", "sphere", shape, other, "n.kind") == 0);
                               CHECK(seen("meet", "shape", "sphere", shape, other, "n.a").is_null());
                             }
                           }},
                          {"distance",
                           [&] {
                             const Json a = line({0, 0, 1}, {1, 0, 0}), b = line({7, 2, 1}, {-3, 0, 0});
                             CHECK(seen("distance", "shape", "other", a, b).get<double>() == Approx(2));
                             CHECK(seen("distance", "shape", "other", plane(1, 1), plane(4, -1)) == 3);
                           }},
                          {"angle",
                           [&] {
                             const Json a = line({0, 0, 1}, {1, 0, 0}), b = line({7, 2, 1}, {-3, 0, 0});
                             CHECK(seen("angle", "shape", "other", a, b).get<double>() == Approx(180));
                             CHECK(seen("angle", "shape", "other", a, a).get<double>() == Approx(0).margin(1e-6));
                           }},
                          {"twist_between",
                           [&] {
                             const Json a = line({0, 0, 1}, {1, 0, 0}), b = line({7, 2, 1}, {3, 0, 0});
                             require_close(carried("twist_between", a, b, 1), {1, 2.5, 0.25});
                             require_close(carried("twist_between", a, b, 0.5), {1, 1.5, 0.25});
                             require_close(carried("twist_between", a, a, 1), {1, 0.5, 0.25});
                           }},
                          {"boost_between", [&] {
                             require_close(carried("boost_between", plane(0, 1), plane(2, 1), 1), {1, 0.5, 2.25});
                           }}});
  /// The circle or line that goes from itself to itself run the other way gets there.
  const auto reverses = [&](const char* type) {
    return [&, type] {
      for (const char* method : {"similarity", "conformal"}) {
        Json inputs = {{"from", from("a")}, {"to", from("b")}, {"method", method}};
        if (std::string(type) != "logarithm") inputs["amount"] = 1;
        if (std::string(type) == "transform_between") inputs["shape"] = from("a");
        Json nodes = with(type, inputs, {{"a", make("circle")}, {"b", make("circle", {{"normal", {0, 0, -1}}})}});
        const bool is_generator = std::string(type) == "logarithm";
        if (is_generator) nodes["moved"] = make("transform", {{"shape", from("a")}, {"generator", from("n")}});
        const Json there = value(nodes, is_generator ? "moved" : "n");
        require_close(triple(there["normal"]), {0, 0, -1}, 1e-12);
        CHECK(there["radius"].get<double>() == Approx(1));
      }
    };
  };
  hold("opposite lines",
       {{"transform_between", reverses("transform_between")},
        {"logarithm", reverses("logarithm")},
        {"blend", reverses("blend")},
        {"twist_between",
         [&] {
           const Json a = line({0, 0, 1}, {1, 0, 0});
           for (const Json& b : {line({0, 2, 1}, {-1, 0, 0}), line({0, 0, 1}, {-2, 0, 0})}) {
             const Json nodes = with("twist_between", {{"shape", from("a")}, {"from", from("a")}, {"to", from("b")}},
                                     {{"a", a}, {"b", b}});
             const Json there = value(nodes), wanted = value(nodes, "b");
             require_close(triple(there["point"]), triple(wanted["point"]), 1e-12);
             require_close(triple(there["direction"]), triple(wanted["direction"]), 1e-12);
             // Half of a half turn is a quarter.
             const Json half = value(
                 with("twist_between", {{"shape", from("a")}, {"from", from("a")}, {"to", from("b")}, {"amount", 0.5}},
                      {{"a", a}, {"b", b}}));
             CHECK(std::abs(half["direction"][0].get<double>()) < 1e-12);
           }
         }},
        {"boost_between", [&] {
           require_close(carried("boost_between", plane(0, 1), plane(2, -1), 1), {1, 0.5, 2.25});
         }}});
}

TEST_CASE("Singular inputs: isoclinic generators") {
  const Point wanted = point(isoclinic, "wanted");
  const auto moves = [&](const char* type) {
    return [&, type] {
      require_close(
          point(with(type, {{"shape", from("spot")}, {"generator", from("both")}, {"amount", 0.7}}, isoclinic)),
          wanted);
    };
  };
  hold("isoclinic generators",
       {{"boost", moves("boost")},
        {"transform", moves("transform")},
        {"orbit",
         [&] {
           const Json nodes =
               with("orbit", {{"point", {1, 0.5, 0.25}}, {"generator", from("both")}, {"from", 0.7}, {"to", 0.9}},
                    isoclinic);
           require_close(graph_of(nodes).all<Point>("n").front(), wanted);
         }},
        {"warp", [&] {
           const Json nodes =
               with("warp", {{"shape", from("spot")}, {"generators", {from("both")}}, {"power", 0}, {"strength", 0.7}},
                    isoclinic);
           require_close(point(nodes), wanted);
         }}});
}
