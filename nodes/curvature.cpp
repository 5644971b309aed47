// Generators that give a flat surface the curvature that is asked for.

#include <array>
#include <cmath>
#include <utility>

#include "algebra/construct.h"
#include "geometry/chunks.h"
#include "geometry/sampling.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/choices.h"
#include "nodes/finish_surface.h"
#include "nodes/shapes.h"

namespace dini {

/// Curvatures as asked, or eq. 18 to the letter.
enum class CurvatureMethod { exact, paper };

template <>
struct ChoiceNames<CurvatureMethod> {
  static constexpr std::array<std::string_view, 2> names = {"exact", "paper"};
};

namespace {

/// Curvatures along two directions of a plane, and where they are asked for.
struct CurvatureSource {
  Point position;
  double along_u = 0, along_v = 0;
};

/// The generator that bends the plane at `source.position + u + v`, u and v being vectors in the plane.
///
/// The boost that curves a line must sit on that line. So what curves along u follows the point along v, and the other
/// way around; a boost that followed along u would sit at the point itself and do nothing. Eq. 18 has it the other way
/// around.
Generator bending(const CurvatureSource& source, const Vector& normal, const Vector& u, const Vector& v,
                  CurvatureMethod method) {
  const Vector position = to_vector(source.position);
  const Generator beside_u = null_pair(to_point(position + u), normal);
  const Generator beside_v = null_pair(to_point(position + v), normal);
  if (method == CurvatureMethod::paper) return source.along_u * beside_u + source.along_v * beside_v;
  return (-0.5 * source.along_u) * beside_v + (-0.5 * source.along_v) * beside_u;
}

struct CurvatureInputs {
  Point position;
  Vector normal, u_direction;
  double curvature_u, curvature_v;
  double u, v;
  CurvatureMethod method;
};

Attempt<Generator> curvature_generator(const CurvatureInputs& in) {
  if (in.normal == Vector{}) return Failure{"degenerate", "the normal must not be zero", "normal"};
  const Vector up = normalized(in.normal);
  Vector ahead = normalized(in.u_direction);
  ahead = normalized(ahead - dot(ahead, up) * up);
  if (ahead == Vector{}) ahead = any_perpendicular(up);
  return bending({in.position, in.curvature_u, in.curvature_v}, up, in.u * ahead, in.v * cross(up, ahead), in.method);
}

/// Weights 0 to 1 whose first and second derivative vanish at both ends, so that near a corner only that corner counts.
double smooth_step(double t) { return t * t * t * (10 + t * (6 * t - 15)); }

struct CurvaturePatchInputs {
  double curvature_u_a, curvature_v_a;
  double curvature_u_b, curvature_v_b;
  double curvature_u_c, curvature_v_c;
  double curvature_u_d, curvature_v_d;
  Point center;
  Vector u_vector, v_vector;
  double amount;
  std::int64_t count_u, count_v;
  CurvatureMethod method;
  Rule rule;
  AtInfinity at_infinity;
  double clip_radius;
};

Attempt<SharedMesh> curvature_patch(const Context& context, const CurvaturePatchInputs& in) {
  const Vector normal = normalized(cross(in.u_vector, in.v_vector));
  const auto corner = [&](double u, double v) {
    return to_point(to_vector(in.center) + u * in.u_vector + v * in.v_vector);
  };
  const std::array<CurvatureSource, 4> corners = {{{corner(-1, -1), in.curvature_u_a, in.curvature_v_a},
                                                   {corner(1, -1), in.curvature_u_b, in.curvature_v_b},
                                                   {corner(-1, 1), in.curvature_u_c, in.curvature_v_c},
                                                   {corner(1, 1), in.curvature_u_d, in.curvature_v_d}}};
  const auto rows = static_cast<std::size_t>(in.count_u), columns = static_cast<std::size_t>(in.count_v);
  const Column<double> us = spaced(0, 1, rows, false, context.cancel()),
                       vs = spaced(0, 1, columns, false, context.cancel());
  Column<Point> points(rows * columns);
  for_chunks(context.cancel(), points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double u = us[i / columns], v = vs[i % columns];
      const bool smooth = in.method == CurvatureMethod::exact;
      const double along = smooth ? smooth_step(u) : u, across = smooth ? smooth_step(v) : v;
      Generator sum;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const double at_u = k % 2 == 0 ? 0 : 1, at_v = k < 2 ? 0 : 1;
        const double weight = (at_u == 0 ? 1 - along : along) * (at_v == 0 ? 1 - across : across);
        sum = sum + weight * bending(corners[k], normal, (2 * (u - at_u)) * in.u_vector, (2 * (v - at_v)) * in.v_vector,
                                     in.method);
      }
      const auto moved = apply(exponential(in.amount * sum, in.rule), corner(2 * u - 1, 2 * v - 1));
      points.set(i, moved.value_or(Point::at_infinity()));
    }
  });
  return finish_surface(context, {points, rows, columns, false, false}, in.at_infinity, in.clip_radius, nullptr);
}

InputSpec curvature_input(double value) { return defaults(value).hard(-1e9, 1e9).soft(-2, 2).unit("1/m"); }

std::size_t patch_vertices(const Literals& literals, const Axes&) {
  return static_cast<std::size_t>(integer_at(literals, "count_u") * integer_at(literals, "count_v"));
}

std::size_t most_patch_vertices(const Literals& literals, const Axes& consumed) {
  return most_of_clipped_grid(patch_vertices(literals, consumed));
}

}  // namespace

void add_curvature(Registry& registry) {
  registry.add(
      node("curvature", curvature_generator)
          .title("Curvature")
          .family("generators")
          .synonyms({"bend", "bending", "curve"})
          .doc("The generator that bends a line or a plane at a point to the curvatures asked for.")
          .source("Boosted Surfaces, eqs. (17), (18), figs. 13, 14")
          .details("With u = v = 0 it is eq. (17): -(curvature_u + curvature_v)/2 times the unit null pair; a line "
                   "through the point becomes a circle of that curvature, bent away from the normal. For a surface, "
                   "give each point of the plane its u and v: the curvature at u = v = 0 is then curvature_u along u "
                   "and curvature_v along v. The paper's eq. (18) lacks the factor -1/2 and exchanges u and v.")
          .degenerate("zero direction",
                      "A zero normal is an error; a zero u_direction, or one along the normal, is replaced by "
                      "a fixed perpendicular.")
          .input("position", &CurvatureInputs::position, "Where the curvatures hold.",
                 defaults({0, 0, 0}).unit("m").position_handle())
          .input("normal", &CurvatureInputs::normal, "Normal of the plane, or of the line; of any length.",
                 defaults({0, 0, 1}).direction_handle("position"))
          .input("u_direction", &CurvatureInputs::u_direction, "Where u runs in the plane; v runs to its left.",
                 defaults({1, 0, 0}).direction_handle("position").title("Direction of u"))
          .input("curvature_u", &CurvatureInputs::curvature_u,
                 "Curvature along u; above 0 it bends against the normal.",
                 curvature_input(1).title("Curvature along u"))
          .input("curvature_v", &CurvatureInputs::curvature_v,
                 "Curvature along v; above 0 it bends against the normal.",
                 curvature_input(0).title("Curvature along v"))
          .input("u", &CurvatureInputs::u, "Place of the bent point along u.",
                 defaults(0).hard(-1e9, 1e9).soft(-2, 2).unit("m").title("Place along u"))
          .input("v", &CurvatureInputs::v, "Place of the bent point along v.",
                 defaults(0).hard(-1e9, 1e9).soft(-2, 2).unit("m").title("Place along v"))
          .input("method", &CurvatureInputs::method, "Curvatures as asked, or eq. (18) to the letter.",
                 defaults("exact"))
          .output("generator", "The generator; boost the point with amount 1."));

  registry.add(
      node("curvature_patch", curvature_patch)
          .title("Curvature patch")
          .family("surfaces")
          .synonyms({"bend", "quad", "sheet", "dome"})
          .doc("A surface patch from the curvatures along u and along v at its four corners.")
          .source("Boosted Surfaces, section 5.1, fig. 15")
          .details("The corners stay where they are and keep their tangent plane. The exact method blends so smoothly "
                   "that the curvatures at each corner are the ones asked for, along both edges; the paper's blends "
                   "eq. (18) bilinearly. Since the corners stay, four equal curvatures make a wave rather than a dome.")
          .degenerate("zero direction", "Vectors that span no plane give an empty mesh.")
          .input("curvature_u_a", &CurvaturePatchInputs::curvature_u_a, "Along u at u = 0, v = 0.",
                 curvature_input(1).title("Along u at 0, 0"))
          .input("curvature_v_a", &CurvaturePatchInputs::curvature_v_a, "Along v at u = 0, v = 0.",
                 curvature_input(1).title("Along v at 0, 0"))
          .input("curvature_u_b", &CurvaturePatchInputs::curvature_u_b, "Along u at u = 1, v = 0.",
                 curvature_input(1).title("Along u at 1, 0"))
          .input("curvature_v_b", &CurvaturePatchInputs::curvature_v_b, "Along v at u = 1, v = 0.",
                 curvature_input(1).title("Along v at 1, 0"))
          .input("curvature_u_c", &CurvaturePatchInputs::curvature_u_c, "Along u at u = 0, v = 1.",
                 curvature_input(1).title("Along u at 0, 1"))
          .input("curvature_v_c", &CurvaturePatchInputs::curvature_v_c, "Along v at u = 0, v = 1.",
                 curvature_input(1).title("Along v at 0, 1"))
          .input("curvature_u_d", &CurvaturePatchInputs::curvature_u_d, "Along u at u = 1, v = 1.",
                 curvature_input(1).title("Along u at 1, 1"))
          .input("curvature_v_d", &CurvaturePatchInputs::curvature_v_d, "Along v at u = 1, v = 1.",
                 curvature_input(1).title("Along v at 1, 1"))
          .input("center", &CurvaturePatchInputs::center, "The middle.",
                 defaults({0, 0, 0}).unit("m").position_handle())
          .input("u_vector", &CurvaturePatchInputs::u_vector, "Half the extent along u.",
                 defaults({1, 0, 0}).unit("m").direction_handle("center").title("Half width"))
          .input("v_vector", &CurvaturePatchInputs::v_vector, "Half the extent along v.",
                 defaults({0, 1, 0}).unit("m").direction_handle("center").title("Half depth"))
          .input("amount", &CurvaturePatchInputs::amount, "Factor of the blended generator.", defaults(1).soft(-2, 2))
          .input("count_u", &CurvaturePatchInputs::count_u, "How many points along u.",
                 defaults(96).hard(2, 65536).soft(8, 256).title("Points along u"))
          .input("count_v", &CurvaturePatchInputs::count_v, "How many points along v.",
                 defaults(96).hard(2, 65536).soft(8, 256).title("Points along v"))
          .input("method", &CurvaturePatchInputs::method, "Curvatures as asked, or eq. (18) to the letter.",
                 defaults("exact"))
          .input("rule", &CurvaturePatchInputs::rule,
                 "The true exponential, or the paper's with the scalar part of the square only.",
                 defaults("exact").title("Exponential"))
          .input("at_infinity", &CurvaturePatchInputs::at_infinity,
                 "What to do where the surface leaves the clip radius.", defaults("clip"))
          .input("clip_radius", &CurvaturePatchInputs::clip_radius, "Distance from the origin that counts as infinity.",
                 defaults(100).hard(1e-3, 1e6).soft(1, 1000).unit("m"))
          .vertices(patch_vertices, most_patch_vertices)
          .thinned_to(8)
          .cost([](const RunSize& size) {
            return RunCost{600 * size.vertices, 190 * size.vertices};
          })
          .output("mesh", "The mesh."));
}

}  // namespace dini
