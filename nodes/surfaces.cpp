#include <algorithm>
#include <cmath>

#include "algebra/extract.h"
#include "geometry/chunks.h"
#include "geometry/circle_grid.h"
#include "geometry/sampling.h"
#include "geometry/surface.h"
#include "geometry/tube.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/choices.h"
#include "nodes/costs.h"
#include "nodes/draft.h"
#include "nodes/finish_surface.h"
#include "nodes/shapes.h"

namespace dini {

namespace {

struct SurfaceInputs {
  std::int64_t segments;
  AtInfinity at_infinity;
  double clip_radius;
};

Attempt<SharedMesh> surface_of_points(const Context& context, const Block<Point, 2>& shape, const SurfaceInputs& in) {
  const PointGrid grid{shape.column(),       shape.size(0), shape.size(1),   shape.axis(0).closed,
                       shape.axis(1).closed, shape.base(),  shape.stride(0), shape.stride(1)};
  return finish_surface(context, grid, in.at_infinity, in.clip_radius, &shape.axis(0));
}

Attempt<SharedMesh> surface_of_circles(const Context& context, const Block<Circle, 1>& shape, const SurfaceInputs& in) {
  std::vector<std::optional<CircleCoordinates>> circles;
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < shape.size() && !steps.stopped(); ++i) circles.push_back(coordinates(shape(i)));
  const auto columns = static_cast<std::size_t>(in.segments);
  const bool closed = shape.axis().closed;
  const Column<Point> points = sample_circle_row(circles, columns, closed, in.clip_radius, context.cancel());
  const PointGrid grid{points, circles.size(), columns, closed, true};
  return finish_surface(context, grid, in.at_infinity, in.clip_radius, &shape.axis());
}

struct TubeInputs {
  double radius;
  std::int64_t segments, sides;
  double clip_radius;
};

SharedMesh tube_along(const Context& context, const Polyline& curve, const TubeInputs& in) {
  TubeSegments used = tube_within_budget(context, curve.points.size(), curve.closed, in.sides);
  const std::size_t budget = context.triangle_budget(), fewest = fewest_points(curve);
  used.points = std::max(used.points, std::min(fewest, curve.points.size()));
  for (;;) {
    Mesh mesh =
        tube(thinned(curve, used.points), {in.radius, used.sides, in.clip_radius, used.capped}, context.cancel());
    const std::size_t triangles = mesh.triangles.size();
    if (budget == 0 || triangles <= budget || used.points <= fewest)
      return std::make_shared<const Mesh>(std::move(mesh));
    // The clip radius cuts the curve into pieces, each with ends of its own.
    used.points = std::max(fewest, std::min(used.points - 1, used.points * budget / triangles));
  }
}

SharedMesh tube_of_points(const Context& context, const Block<Point, 1>& shape, const TubeInputs& in) {
  Polyline curve{Column<Point>(shape.size()), shape.axis().closed};
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < shape.size() && !steps.stopped(); ++i) curve.points.set(i, shape(i));
  return tube_along(context, curve, in);
}

Attempt<SharedMesh> tube_of_circle(const Context& context, const Circle& shape, const TubeInputs& in) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle to put a tube around", "shape"};
  const auto segments = static_cast<std::size_t>(in.segments);
  const std::size_t used = tube_within_budget(context, segments, true, in.sides).points;
  Polyline curve{Column<Point>(found->line ? 2 : used), !found->line};
  if (found->line) {
    // The chord of the clip sphere, a hair shorter so that round-off leaves its ends inside.
    const double distance = std::min(length(to_vector(found->point)), in.clip_radius);
    const double chord = 2 * (1 - 1e-9) * std::sqrt((in.clip_radius - distance) * (in.clip_radius + distance));
    curve.points.set(0, point_at(*found, -0.5, chord));
    curve.points.set(1, point_at(*found, 0.5, chord));
  } else {
    curve.points = sample_circle_row({found}, used, false, in.clip_radius, context.cancel());
  }
  return tube_along(context, curve, in);
}

struct PatchInputs {
  Generator a, b, c, d;
  Point center;
  Vector u_vector, v_vector;
  double amount;
  std::int64_t count_u, count_v;
  Rule rule;
  AtInfinity at_infinity;
  double clip_radius;
};

Attempt<SharedMesh> patch_mesh(const Context& context, const PatchInputs& in) {
  const auto rows = static_cast<std::size_t>(in.count_u);
  const auto columns = static_cast<std::size_t>(in.count_v);
  const Column<double> u = spaced(0, 1, rows, false, context.cancel());
  const Column<double> v = spaced(0, 1, columns, false, context.cancel());
  Column<Point> points(rows * columns);
  const kernels::BilinearCorners corners{in.a, in.b, in.c, in.d};
  for_chunks(context.cancel(), rows, std::max<std::size_t>(1, usual_chunk / columns), [&](auto begin, auto end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        points.set(i * columns + j,
                   to_point(to_vector(in.center) + (2 * u[i] - 1) * in.u_vector + (2 * v[j] - 1) * in.v_vector));
      }
      const double along = u[i];
      kernels::transform_points_bilinear(corners, {&along, true}, {v.component(0), false}, {&in.amount, true}, in.rule,
                                         components(std::as_const(points), i * columns),
                                         components(points, i * columns), columns);
    }
  });
  const PointGrid grid{points, rows, columns, false, false};
  return finish_surface(context, grid, in.at_infinity, in.clip_radius, nullptr);
}

std::size_t surface_vertices(const Literals& literals, const Axes& consumed) {
  const std::size_t across =
      consumed.size() == 2 ? consumed[1].size : static_cast<std::size_t>(integer_at(literals, "segments"));
  return consumed[0].size * across;
}

/// Two for a quad; two quads along an open axis, and three around a closed one, as around a circle.
std::size_t fewest_of_surface(const Axes& consumed) {
  const bool closed = consumed.size() < 2 || consumed[1].closed;
  return std::size_t{2} * (consumed[0].closed ? 3 : 2) * (closed ? 3 : 2);
}

/// Three sides and one step, or three steps around a closed curve.
std::size_t fewest_of_tube(const Axes& consumed) { return consumed.empty() || consumed[0].closed ? 18 : 6; }

std::size_t points_along(const Literals& literals, const Axes& consumed) {
  return consumed.empty() ? static_cast<std::size_t>(integer_at(literals, "segments")) : consumed[0].size;
}

/// Of one tube with a cap at each end, but for the centers of the caps.
std::size_t tube_vertices(const Literals& literals, const Axes& consumed) {
  const auto sides = static_cast<std::size_t>(integer_at(literals, "sides"));
  return (points_along(literals, consumed) + 2) * sides;
}

/// If every other point of the curve is beyond the clip radius: pieces of one point and the two where its steps are
/// cut, each with two caps.
std::size_t most_tube_vertices(const Literals& literals, const Axes& consumed) {
  const auto sides = static_cast<std::size_t>(integer_at(literals, "sides"));
  const std::size_t pieces = points_along(literals, consumed) / 2 + 1;
  return std::max(tube_vertices(literals, consumed) + 2, pieces * (5 * sides + 2));
}

std::size_t patch_vertices(const Literals& literals, const Axes&) {
  return static_cast<std::size_t>(integer_at(literals, "count_u") * integer_at(literals, "count_v"));
}

std::size_t most_surface_vertices(const Literals& literals, const Axes& consumed) {
  return most_of_clipped_grid(surface_vertices(literals, consumed));
}

std::size_t most_patch_vertices(const Literals& literals, const Axes& consumed) {
  return most_of_clipped_grid(patch_vertices(literals, consumed));
}

InputSpec clip_radius_input(double value) { return defaults(value).hard(1e-3, 1e6).soft(1, 1000).unit("m"); }

}  // namespace

void add_surfaces(Registry& registry) {
  registry.add(
      node("surface", surface_of_points, surface_of_circles)
          .title("Surface")
          .family("surfaces")
          .synonyms({"loft", "skin", "lathe", "sweep", "revolve", "mesh"})
          .doc("A mesh through points over two axes, or through circles over one.")
          .details("Closed axes are welded. Rows that shrink to a point become clean poles. Where the surface passes "
                   "through "
                   "infinity it is cut at the clip radius, with a warning, or the node fails, as at_infinity says.")
          .degenerate("circle to line", "The row runs to the clip radius and is cut there.")
          .degenerate("zero radius", "The row is one point, a clean pole.")
          .degenerate("coincident points", "They become one vertex; without area the mesh is empty.")
          .input("shape", "Points over two axes, or circles over one.")
          .input("segments", &SurfaceInputs::segments, "Points around each circle; points over two axes do not use it.",
                 defaults(96).hard(3, 65536).soft(8, 256))
          .input("at_infinity", &SurfaceInputs::at_infinity, "What to do where the surface leaves the clip radius.",
                 defaults("clip"))
          .input("clip_radius", &SurfaceInputs::clip_radius, "Distance from the origin that counts as infinity.",
                 clip_radius_input(100))
          .consumed_axis("over", "The axis of rows, or of circles; empty means the last that along leaves.")
          .consumed_axis("along", "The axis along a row of points; empty means the last.")
          .vertices(surface_vertices, most_surface_vertices)
          .thinned_to(fewest_of_surface)
          .cost(cost_of_grid_surface)
          .output("mesh", "The mesh; one for each value of the axes that are left."));

  registry.add(
      node("tube", tube_of_points, tube_of_circle)
          .title("Tube")
          .family("surfaces")
          .synonyms({"pipe", "sweep", "cable", "wire", "hose", "thicken"})
          .doc("A round tube along a curve: points over one axis, or a circle.")
          .details("A closed axis makes a closed tube. Parts beyond the clip radius are left out.")
          .degenerate("circle to line", "A straight tube as long as the clip radius allows.")
          .degenerate("zero radius", "A circle of radius zero has no tube: an empty mesh.")
          .degenerate("coincident points", "Repeated points are skipped; if all agree the mesh is empty.")
          .input("shape", "Points over one axis, or a circle or line.")
          .input("radius", &TubeInputs::radius, "Radius of the tube.",
                 defaults(0.02).hard(1e-9, 1e6).soft(0.005, 0.2).unit("m"))
          .input("segments", &TubeInputs::segments, "Points along a circle; a curve of points does not use it.",
                 defaults(128).hard(3, 65536).soft(16, 512))
          .input("sides", &TubeInputs::sides, "Corners around the tube.", defaults(16).hard(3, 1024).soft(4, 32))
          .input("clip_radius", &TubeInputs::clip_radius,
                 "Distance from the origin that counts as infinity; a line ends there.", clip_radius_input(100))
          .consumed_axis("over", "The axis along the curve; empty means the last.")
          .vertices(tube_vertices, most_tube_vertices)
          .thinned_to(fewest_of_tube)
          .cost([](const RunSize& size) {
            return RunCost{50 * size.vertices, 80 * size.vertices};
          })
          .output("mesh", "The mesh; one for each value of the axes that are left."));

  registry.add(
      node("patch", patch_mesh)
          .title("Patch")
          .family("surfaces")
          .synonyms({"coons", "quad", "bezier", "sheet", "four corners"})
          .doc("A surface patch: every point of a flat parallelogram moved by the bilinear blend of four generators.")
          .source("Boosted Surfaces, eq. (15), fig. 11")
          .details("The parallelogram spans center - u_vector - v_vector to center + u_vector + v_vector.")
          .degenerate("point at a generator", "A corner that stands at its own null pair stays.")
          .degenerate("zero direction", "Vectors that span no plane give an empty mesh.")
          .input("a", &PatchInputs::a, "Generator at u = 0, v = 0.", required().title("At u 0, v 0"))
          .input("b", &PatchInputs::b, "Generator at u = 1, v = 0.", required().title("At u 1, v 0"))
          .input("c", &PatchInputs::c, "Generator at u = 0, v = 1.", required().title("At u 0, v 1"))
          .input("d", &PatchInputs::d, "Generator at u = 1, v = 1.", required().title("At u 1, v 1"))
          .input("center", &PatchInputs::center, "The middle.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("u_vector", &PatchInputs::u_vector, "Half the extent along u.",
                 defaults({1, 0, 0}).unit("m").direction_handle("center").title("Half width"))
          .input("v_vector", &PatchInputs::v_vector, "Half the extent along v.",
                 defaults({0, 1, 0}).unit("m").direction_handle("center").title("Half depth"))
          .input("amount", &PatchInputs::amount, "Factor of the blended generator.", defaults(1).soft(-2, 2))
          .input("count_u", &PatchInputs::count_u, "How many points along u.",
                 defaults(96).hard(2, 65536).soft(8, 256).title("Points along u"))
          .input("count_v", &PatchInputs::count_v, "How many points along v.",
                 defaults(96).hard(2, 65536).soft(8, 256).title("Points along v"))
          .input("rule", &PatchInputs::rule,
                 "The true exponential, or the paper's with the scalar part of the square only.",
                 defaults("exact").title("Exponential"))
          .input("at_infinity", &PatchInputs::at_infinity, "What to do where the surface leaves the clip radius.",
                 defaults("clip"))
          .input("clip_radius", &PatchInputs::clip_radius, "Distance from the origin that counts as infinity.",
                 clip_radius_input(100))
          .vertices(patch_vertices, most_patch_vertices)
          .thinned_to(8)
          .cost(cost_of_grid_surface)
          .output("mesh", "The mesh."));
}

}  // namespace dini
