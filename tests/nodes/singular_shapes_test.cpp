// What every node does with shapes that have no usual answer: circles that are lines, that have no radius or no
// direction. One test for each kind, one entry for each node whose card says something about it.

#include "tests/nodes/singular.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json shrunk = make("circle", {{"center", {1, 2, 3}}, {"normal", {0, 0, 2}}, {"radius", 0}});

const Json straight = make("line", {{"point", {0, 2, 1}}, {"direction", {3, 0, 0}}});

/// A circle boosted to a line: at amount 1 the unit circle is the line x = 1/2.
const Json opened = {{"unit", make("circle")},
                     {"tau", make("point_pair", {{"direction", {1, 0, 0}}})},
                     {"opened", make("boost", {{"shape", from("unit")}, {"generator", from("tau")}})}};

}  // namespace

TEST_CASE("Cards speak of singular inputs in the same words, in sentences") {
  for (const auto& [id, type] : catalogue().types()) {
    for (const Degenerate& one : type.degenerate) {
      CAPTURE(id, one.input);
      CHECK(kinds.contains(one.input));
      CHECK(one.result.ends_with('.'));
    }
  }
}

TEST_CASE("Singular inputs: a circle becomes a line") {
  const auto opens = [](const char* type) {
    return [type] {
      require_line(value(with(type, {{"shape", from("unit")}, {"generator", from("tau")}}, opened)), {0.5, 0, 0},
                   {0, 1, 0});
    };
  };
  /// A node that needs a line takes one that was a circle, and refuses a circle.
  const auto needs_line = [](const char* type, const char* port, Json inputs) {
    return [=] {
      Json right = inputs, wrong = inputs;
      right[port] = from("opened");
      wrong[port] = from("unit");
      const Json others = plus(opened, {{"spot", spot}, {"other", straight}});
      CHECK(graph_of(with(type, right, others)).problems("n").empty());
      require_degenerate(with(type, wrong, others), port);
    };
  };
  const auto refuses = [](const char* type) {
    return [type] { require_degenerate(with(type, {{"shape", from("opened")}}, opened), "shape"); };
  };
  hold("circle to line",
       {{"boost", opens("boost")},
        {"transform", opens("transform")},
        {"twist", needs_line("twist", "axis", {{"shape", from("spot")}})},
        {"rotate", needs_line("rotate", "axis", {{"shape", from("spot")}})},
        {"rotation", needs_line("rotation", "axis", Json::object())},
        {"array_around", needs_line("array_around", "axis_line", {{"shape", from("spot")}})},
        {"twist_between", needs_line("twist_between", "from", {{"shape", from("spot")}, {"to", from("other")}})},
        {"axis_of", refuses("axis_of")},
        {"poles_of", refuses("poles_of")},
        {"radius_of", refuses("radius_of")},
        {"reflect",
         [] {
           const Json ball = plus(opened, {{"ball", make("sphere", {{"center", {-1, 0, 0}}})}});
           require_line(value(with("reflect", {{"shape", from("unit")}, {"mirror", from("ball")}}, ball)), {-0.5, 0, 0},
                        {0, 1, 0});
         }},
        {"transform_between",
         [] {
           Json inputs = {{"shape", from("unit")}, {"from", from("unit")}, {"to", from("opened")}};
           require_degenerate(with("transform_between", inputs, opened), "to");
           inputs["method"] = "conformal";
           require_line(value(with("transform_between", inputs, opened)), {0.5, 0, 0}, {0, 1, 0});
         }},
        {"center_of",
         [] {
           CHECK(point(with("center_of", {{"shape", from("opened")}}, opened)) == Point::at_infinity());
         }},
        {"circle_through",
         [] {
           require_line(value(with("circle_through", {{"a", {1, 1, 0}}, {"b", {1, 5, 0}}, {"c", {1, 9, 0}}})),
                        {1, 0, 0}, {0, 1, 0});
         }},
        {"hopf",
         [] {
           for (const char* method : {"exact", "paper"}) {
             require_line(value(with("hopf", {{"shape", from("unit")}, {"latitude", 1}, {"method", method}}, opened)),
                          {0, 0, 0}, {0, 0, 1});
           }
           require_degenerate(with("hopf", {{"shape", from("opened")}}, opened), "shape");
         }},
        {"sample",
         [] {
           const Json nodes =
               with("sample", {{"shape", from("opened")}, {"count", 3}, {"closed", false}, {"length", 4}}, opened);
           const std::vector<Point> points = graph_of(nodes).all<Point>("n");
           require_close(points[0], {0.5, -2, 0});
           require_close(points[1], {0.5, 0, 0});
           require_close(points[2], {0.5, 2, 0});
         }},
        {"surface",
         [] {
           const Json amounts = {{"k", make("range", {{"from", 0.6}, {"to", 1}, {"count", 9}})}};
           Json nodes = plus(opened, amounts);
           nodes["opened"]["inputs"]["amount"] = from("k");
           CatalogueGraph graph = graph_of(with("surface", {{"shape", from("opened")}, {"clip_radius", 20}}, nodes));
           const SharedMesh mesh = graph.one<SharedMesh>("n");
           double farthest = 0;
           for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
             farthest = std::max(farthest, length(to_vector(mesh->positions[i])));
           }
           CHECK(farthest == Approx(20).epsilon(1e-9));
           CHECK_FALSE(graph.warnings().empty());
         }},
        {"tube", [] {
           const Json bounds = value(with("tube", {{"shape", from("opened")}, {"clip_radius", 20}}, opened))["bounds"];
           CHECK(bounds[1][1].get<double>() == Approx(std::sqrt(20 * 20 - 0.25)).epsilon(1e-6));
         }}});
}

TEST_CASE("Singular inputs: a zero radius") {
  const Json c = {
      {"c", shrunk}, {"s", make("sphere", {{"center", {1, 2, 3}}, {"radius", 0}})}, {"unit", make("sphere")}};
  const auto shape = [&](const char* type, const std::string& place = "n") {
    return value(with(type, {{"shape", from("c")}}, c), place);
  };
  const auto keeps = [&](const char* type) {
    return [&, type] {
      const Json tau = plus(c, {{"tau", make("point_pair")}});
      CHECK(value(with(type, {{"shape", from("c")}, {"generator", from("tau")}}, tau))["radius"].get<double>() < 1e-7);
    };
  };
  hold("zero radius",
       {{"circle",
         [] {
           const Json circle = value({{"n", shrunk}});
           CHECK(circle["radius"] == 0);
           require_close(triple(circle["center"]), {1, 2, 3});
           require_close(triple(circle["normal"]), {0, 0, 1});
         }},
        {"sphere", [&] { CHECK(value(c, "s")["radius"] == 0); }},
        {"boost", keeps("boost")},
        {"transform", keeps("transform")},
        {"axis_of",
         [&] {
           require_line(shape("axis_of"), {1, 2, 0}, {0, 0, 1});
         }},
        {"poles_of",
         [&] {
           for (const char* place : {"n.a", "n.b"}) require_close(triple(shape("poles_of", place)), {1, 2, 3});
           const Json null = {{"tau", make("point_pair", {{"position", {1, 2, 3}}})}};
           require_close(triple(value(with("poles_of", {{"shape", from("tau")}}, null), "n.b")), {1, 2, 3});
         }},
        {"center_of",
         [&] {
           require_close(triple(shape("center_of")), {1, 2, 3});
         }},
        {"radius_of", [&] { CHECK(shape("radius_of") == 0); }},
        {"reflect",
         [&] {
           require_degenerate(with("reflect", {{"shape", from("c")}, {"mirror", from("s")}}, c), "mirror");
         }},
        {"mirror",
         [&] {
           const Json body = plus(c, {{"body", make("box_mesh")}});
           require_degenerate(with("mirror", {{"shape", from("body")}, {"mirror", from("s")}}, body), "mirror");
         }},
        {"helix",
         [] {
           for (const Point& p : graph_of(with("helix", {{"radius", 0}, {"count", 5}})).all<Point>("n")) {
             CHECK((p.x == 0 && p.y == 0));
           }
         }},
        {"meet",
         [&] {
           const Json through = plus(c, {{"plane", make("plane", {{"point", {0, 0, 3}}})}, {"other", make("plane")}});
           for (const char* given : {"c", "s"}) {
             const Json touching = with("meet", {{"shape", from(given)}, {"sphere", from("plane")}}, through);
             CHECK(value(touching, "n.kind") == 0);
             require_close(point(touching, "n.a"), {1, 2, 3});
             CHECK(value(with("meet", {{"shape", from(given)}, {"sphere", from("other")}}, through), "n.kind") == -1);
           }
         }},
        {"project",
         [&] {
           for (const char* given : {"c", "s"}) {
             require_close(point(with("project", {{"shape", from(given)}, {"point", {4, 2, 7}}}, c)), {1, 2, 3});
             CHECK(value(with("project", {{"shape", from(given)}, {"point", {4, 2, 7}}}, c), "n.distance") == 5);
           }
         }},
        {"distance",
         [&] {
           CHECK(value(with("distance", {{"shape", from("c")}, {"other", {4, 2, 7}}}, c)) == 5);
         }},
        {"angle",
         [&] {
           require_degenerate(with("angle", {{"shape", from("unit")}, {"other", from("s")}}, c), "other");
           require_degenerate(with("angle", {{"shape", from("c")}, {"other", from("unit")}}, c), "shape");
         }},
        {"transform_between",
         [&] {
           const Json ring = plus(c, {{"ring", make("circle")}});
           for (const char* method : {"similarity", "conformal"}) {
             Json inputs = {{"shape", from("ring")}, {"from", from("c")}, {"to", from("ring")}, {"method", method}};
             require_degenerate(with("transform_between", inputs, ring), "from");
           }
         }},
        {"logarithm",
         [&] {
           require_degenerate(with("logarithm", {{"from", from("s")}, {"to", from("unit")}}, c), "from");
         }},
        {"blend",
         [&] {
           require_degenerate(with("blend", {{"from", from("c")}, {"to", from("c")}}, c), "from");
         }},
        {"boost_between",
         [&] {
           require_degenerate(
               with("boost_between", {{"shape", from("c")}, {"from", from("s")}, {"to", from("unit")}}, c), "from");
         }},
        {"hopf",
         [&] {
           require_degenerate(with("hopf", {{"shape", from("c")}}, c), "shape");
         }},
        {"sample",
         [&] {
           for (const Point& p : graph_of(with("sample", {{"shape", from("c")}}, c)).all<Point>("n")) {
             require_close(p, {1, 2, 3});
           }
         }},
        {"surface",
         [] {
           const Json cone = {{"r", make("range", {{"from", 0}, {"to", 1}, {"count", 5}})},
                              {"up", make("vector", {{"z", from("r")}})},
                              {"c", make("circle", {{"radius", from("r")}})},
                              {"m", make("translate", {{"shape", from("c")}, {"vector", from("up")}})}};
           // A fan of 8 triangles at the pole, then three rows of quads.
           CHECK(triangles(with("surface", {{"shape", from("m")}, {"segments", 8}}, cone)) == 8 + 3 * 16);
         }},
        {"tube",
         [&] {
           CHECK(triangles(with("tube", {{"shape", from("c")}}, c)) == 0);
         }},
        {"sphere_mesh",
         [] {
           require_degenerate(with("sphere_mesh", {{"radius", 0}}), "radius", "out-of-range");
         }},
        {"torus_mesh", [] {
           require_degenerate(with("torus_mesh", {{"minor_radius", 0}}), "minor_radius", "out-of-range");
         }}});
}

TEST_CASE("Singular inputs: a zero direction") {
  const Json zero = {0, 0, 0};
  const Json others = {{"spot", spot},
                       {"none", make("point_pair", {{"direction", zero}})},
                       {"tau", make("point_pair")},
                       {"ball", make("sphere_mesh", {{"segments", 6}, {"rings", 4}})}};
  const auto refused = [&](const char* type, const char* port, Json inputs = Json::object()) {
    return [=] {
      Json given = inputs;
      given[port] = Json::array({0, 0, 0});
      require_degenerate(with(type, given, others), port);
    };
  };
  const auto is_zero = [&](const char* type) {
    return [=] { CHECK(graph_of(with(type, {{"direction", zero}})).one<Generator>("n") == Generator{}); };
  };
  const auto stays = [&](const char* type, Json inputs) {
    return [=] {
      Json given = inputs;
      given["shape"] = from("spot");
      CHECK(point(with(type, given, others)) == Point{1, 0.5, 0.25});
    };
  };
  const auto is_empty = [&](const char* type, Json inputs) {
    return [=] {
      Json given = inputs;
      given["u_vector"] = zero;
      CHECK(triangles(with(type, given, others)) == 0);
    };
  };
  hold("zero direction",
       {{"circle", refused("circle", "normal")},
        {"line", refused("line", "direction")},
        {"plane", refused("plane", "normal")},
        {"flow",
         [&] {
           const Json nodes = with("flow", {{"point", {1, 2, 3}}, {"generator", from("none")}}, others);
           CHECK(graph_of(nodes).one<Vector>("n.velocity") == Vector{});
           CHECK(value(nodes, "n.torsion") == 0);
         }},
        {"osculating_sphere", refused("osculating_sphere", "normal")},
        {"helix", refused("helix", "direction")},
        {"slice", refused("slice", "normal", {{"shape", from("ball")}})},
        {"array",
         [&] {
           const Json nodes = with("array", {{"shape", from("spot")}, {"step", zero}}, others);
           for (const Point& p : graph_of(nodes).all<Point>("n")) CHECK(p == Point{1, 0.5, 0.25});
         }},
        {"array_along",
         [&] {
           const Json curve = plus(others, {{"way", make("helix", {{"count", 6}})}});
           const auto along = [&](const Json& up) {
             return graph_of(with("array_along", {{"shape", from("spot")}, {"curve", from("way")}, {"up", up}}, curve))
                 .all<Point>("n");
           };
           CHECK(along(zero) == along({0, 0, 2}));
         }},
        {"torus_mesh", refused("torus_mesh", "axis")},
        {"contour", refused("contour", "normal", {{"generators", {from("tau")}}})},
        {"point_pair", is_zero("point_pair")},
        {"direction", is_zero("direction")},
        {"boost", stays("boost", {{"generator", from("none")}})},
        {"transform", stays("transform", {{"generator", from("none")}})},
        {"translate", stays("translate", {{"vector", zero}})},
        {"loxodrome",
         [&] {
           stays("loxodrome", {{"a", zero}, {"b", zero}})();
           const Point moved =
               point(with("loxodrome", {{"shape", from("spot")}, {"a", zero}, {"b", {0, 1, 0}}}, others));
           require_close(moved, {1, 0.5 - 2, 0.25});
         }},
        {"warp",
         [&] {
           stays("warp", {{"generators", {from("none")}}})();
           const Json slide = plus(others, {{"slide", make("direction")}});
           require_degenerate(with("warp", {{"shape", from("spot")}, {"generators", {from("slide")}}}, slide),
                              "generators");
         }},
        {"center_of",
         [&] {
           require_degenerate(with("center_of", {{"shape", from("none")}}, others), "shape");
         }},
        {"curvature",
         [&] {
           refused("curvature", "normal")();
           const auto along = [](const Json& direction) {
             return graph_of(with("curvature", {{"u_direction", direction}, {"u", 0.3}})).one<Generator>("n");
           };
           CHECK(along({0, 0, 5}) == along({0, 0, 0}));
           CHECK(is_finite(along({0, 0, 0}).no_e));
         }},
        {"grid",
         [&] {
           const std::vector<Point> points =
               graph_of(with("grid", {{"u_vector", zero}, {"count_u", 2}, {"count_v", 2}})).all<Point>("n");
           CHECK(points[0] == points[2]);
           CHECK(points[1] == points[3]);
         }},
        {"patch", is_empty("patch", {{"a", from("tau")}, {"b", from("tau")}, {"c", from("tau")}, {"d", from("tau")}})},
        {"curvature_patch", is_empty("curvature_patch", Json::object())}});
}
