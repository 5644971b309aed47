// Curves of a field: the orbits of a generator, and the curves across them.

#include <cmath>

#include "geometry/sampling.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/choices.h"
#include "nodes/shapes.h"
#include "nodes/sources.h"

namespace dini {

namespace {

Made<Point> orbit_points(const Point& point, const Generator& generator, double from, double to, std::int64_t count,
                         const std::string&, Rule rule) {
  const auto size = static_cast<std::size_t>(count);
  const Column<double> amounts = spaced(from, to, size, false);
  Made<Point> orbit{Column<Point>(size)};
  for (std::size_t i = 0; i < size; ++i) orbit.values.set(i, point);
  kernels::ConstGenerators one{{}, true};
  Column<Generator> column(1);
  column.set(0, generator);
  for (std::size_t k = 0; k < column.width; ++k) one.components[k] = column.component(k);
  kernels::transform_points(one, {amounts.component(0), false}, rule, components(std::as_const(orbit.values), 0),
                            components(orbit.values, 0), size);
  return orbit;
}

/// Unit directions across the displacements of a field, in the plane of a normal.
class AcrossField {
 public:
  AcrossField(std::vector<kernels::WarpSource> sources, const kernels::WarpSettings& settings, const Vector& normal)
      : sources_(std::move(sources)), settings_(settings), normal_(normal) {}

  /// Zero where the field vanishes, is not finite, or is along the normal.
  Vector at(const Vector& place) const {
    Vector moved;
    kernels::warp_points(sources_, settings_, {&place.x, &place.y, &place.z}, {&moved.x, &moved.y, &moved.z}, 1);
    const Vector across = cross(normal_, moved - place);
    return is_finite(across) ? normalized(across) : Vector{};
  }

  /// One step of the classical Runge-Kutta method; stays where the field gives no direction.
  Vector step(const Vector& place, double length) const {
    const Vector first = at(place);
    const Vector second = at(place + (0.5 * length) * first);
    const Vector third = at(place + (0.5 * length) * second);
    const Vector last = at(place + length * third);
    if (first == Vector{} || second == Vector{} || third == Vector{} || last == Vector{}) return place;
    return place + (length / 6) * (first + 2 * second + 2 * third + last);
  }

 private:
  std::vector<kernels::WarpSource> sources_;
  kernels::WarpSettings settings_;
  Vector normal_;
};

Attempt<Made<Point>> contour_points(const Context& context, const Point& point, const Block<Generator, 1>& generators,
                                    const std::string&, const Vector& normal, double length, std::int64_t count,
                                    const std::string&, double strength, double power, double softening, Rule rule,
                                    kernels::WarpMethod method) {
  if (normal == Vector{}) return Failure{"degenerate", "the normal of the plane must not be zero", "normal"};
  Attempt<std::vector<kernels::WarpSource>> sources = sources_of(generators);
  if (const auto* failure = std::get_if<Failure>(&sources)) return *failure;
  const AcrossField field(std::move(std::get<0>(sources)), {strength, power, softening, rule, method},
                          normalized(normal));
  const auto size = static_cast<std::size_t>(count);
  constexpr int steps_per_point = 4;
  const double step = size > 1 ? length / (static_cast<double>(size - 1) * steps_per_point) : 0.0;
  Made<Point> contour{Column<Point>(size)};
  Vector place = to_vector(point);
  for (std::size_t i = 0; i < size && !context.cancel().stopped(); ++i) {
    contour.values.set(i, to_point(place));
    for (int k = 0; k < steps_per_point && is_finite(place); ++k) place = field.step(place, step);
  }
  return contour;
}

AxisRule open_axis() {
  return [](const Literals& literals, const std::string& node_id) {
    const std::string& given = text_at(literals, "axis");
    const auto size = static_cast<std::size_t>(integer_at(literals, "count"));
    return std::vector<Axes>{{{given.empty() ? node_id : given, size, false}}};
  };
}

}  // namespace

void add_curves(Registry& registry) {
  registry.add(node("orbit", orbit_points)
                   .title("Orbit")
                   .family("fields")
                   .doc("Where exp(t * generator) carries a point, for t along a new axis.")
                   .source("Boosted Surfaces, section 4, fig. 8")
                   .details("A fixed point of the generator stays. Orbits that pass through infinity hold points at "
                            "infinity, which tubes "
                            "and surfaces leave out.")
                   .input("point", "Where the orbit passes at t = 0.", defaults({1, 0, 0}).unit("m").position_handle())
                   .input("generator", "What moves the point.")
                   .input("from", "First t.", defaults(0).hard(-1e6, 1e6).soft(-4, 4))
                   .input("to", "Last t.", defaults(1).hard(-1e6, 1e6).soft(-4, 4))
                   .input("count", "How many points.", defaults(64).hard(1, 1'000'000).soft(2, 256))
                   .input("axis", "Name of the axis; empty means the id of this node.", defaults("").names_axis())
                   .input("rule", "The true exponential, or the paper's with the scalar part of the square only.",
                          defaults("exact"))
                   .axes(open_axis())
                   .makes_curves()
                   .output("points", "The orbit, over the new axis."));

  registry.add(
      node("contour", contour_points)
          .title("Contour")
          .family("fields")
          .doc("The curve through a point that runs across the displacements of a field in a plane: an equipotential "
               "line.")
          .source("Boosted Surfaces, figs. 8, 9")
          .details("The field moves points as warp does with the same inputs. The curve has points at even distances "
                   "along it, is "
                   "found by the classical Runge-Kutta method, and stops where the field gives no direction: at a "
                   "fixed point, or "
                   "where points move along the normal. A zero normal is an error.")
          .input("point", "Where the curve starts.", defaults({1, 0, 0}).unit("m").position_handle())
          .input("generators", "Several links, or one family.", required().several())
          .input("over", "The axis to sum over; empty means the last of generators.", defaults("").names_axis())
          .input("normal", "Normal of the plane of the curve.", defaults({0, 0, 1}).direction_handle("point"))
          .input("length", "Length of the curve; below 0 it runs the other way.",
                 defaults(4).hard(-1e6, 1e6).soft(-10, 10).unit("m"))
          .input("count", "How many points.", defaults(64).hard(1, 100'000).soft(2, 256))
          .input("axis", "Name of the axis; empty means the id of this node.", defaults("").names_axis())
          .input("strength", "Factor of the sum.", defaults(0.01).hard(-1e9, 1e9).soft(-2, 2))
          .input("power", "Power of the distance; 0 gives every generator the same weight.",
                 defaults(0).hard(0, 16).soft(0, 4))
          .input("softening", "Added to the power of the distance.", defaults(0).hard(0, 1e9).soft(0, 2))
          .input("rule", "The true exponential, or the paper's with the scalar part of the square only.",
                 defaults("exact"))
          .input("method", "One rotor from the summed generators, or the sum of what each would do alone.",
                 defaults("sum_generators"))
          .over({"over"})
          .axes(open_axis())
          .makes_curves()
          .output("points", "The curve, over the new axis."));
}

}  // namespace dini
