// Curves of a field: the orbits of a generator, and the curves across them.

#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/field_line.h"
#include "geometry/sampling.h"
#include "nodes/all.h"
#include "nodes/costs.h"
#include "nodes/shapes.h"
#include "nodes/warp_inputs.h"

namespace dini {

namespace {

/// The images of a point under one generator.
class Orbit {
 public:
  Orbit(const Point& point, const Generator& generator, Rule rule) : point_(point), rule_(rule), column_(1) {
    column_.set(0, generator);
    for (std::size_t k = 0; k < Column<Generator>::width; ++k) generator_.components[k] = column_.component(k);
  }
  Orbit(const Orbit&) = delete;  // its generator points into its column

  Column<Point> at(const Column<double>& amounts, const Cancel& cancel) const {
    Column<Point> points(amounts.size());
    for_chunks(cancel, points.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) points.set(i, point_);
      kernels::transform_points(generator_, {amounts.component(0) + begin, false}, rule_,
                                components(std::as_const(points), begin), components(points, begin), end - begin);
    });
    return points;
  }

  bool is_within(double amount, double radius) const {
    Vector image;
    kernels::transform_points(generator_, {&amount, true}, rule_, {&point_.x, &point_.y, &point_.z},
                              {&image.x, &image.y, &image.z}, 1);
    return length(image) <= radius;
  }

  /// The last amount from `inside` towards `outside` whose image is within a radius.
  double last_within(double inside, double outside, double radius) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inside + outside);
      (is_within(middle, radius) ? inside : outside) = middle;
    }
    return inside;
  }

 private:
  Point point_;
  Rule rule_;
  Column<Generator> column_;
  kernels::ConstGenerators generator_{{}, true};
};

/// Where an orbit leaves a radius, looked for from `start` on among the amounts.
double clipped_end(const Orbit& orbit, const Column<double>& amounts, double start, bool upward, double radius,
                   const Cancel& cancel) {
  double inside = start;
  CancelEvery steps(cancel);
  for (std::size_t k = 0; k < amounts.size() && !steps.stopped(); ++k) {
    const double amount = amounts[upward ? k : amounts.size() - 1 - k];
    if (upward ? amount <= start : amount >= start) continue;
    if (!orbit.is_within(amount, radius)) return orbit.last_within(inside, amount, radius);
    inside = amount;
  }
  return inside;
}

struct OrbitInputs {
  Point point;
  Generator generator;
  double from, to;
  std::int64_t count;
  double clip_radius;
  Rule rule;
};

Made<Point> orbit_points(const Context& context, const OrbitInputs& in) {
  const Cancel& cancel = context.cancel();
  const auto size = static_cast<std::size_t>(in.count);
  const Orbit orbit(in.point, in.generator, in.rule);
  Made<Point> made{orbit.at(spaced(in.from, in.to, size, false, cancel), cancel)};
  const auto is_outside = [&](std::size_t i) { return !(length(to_vector(made.values[i])) <= in.clip_radius); };
  bool leaves = false;
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < size && !steps.stopped(); ++i) leaves = leaves || is_outside(i);
  if (!leaves) return made;
  const auto [least, most] = std::minmax({in.from, in.to});
  const double start = std::clamp(0.0, least, most);
  if (!orbit.is_within(start, in.clip_radius)) {
    for (std::size_t i = 0; i < size && !steps.stopped(); ++i) made.values.set(i, Point::at_infinity());
    return made;
  }
  // The amounts in rising order, whichever way the orbit runs.
  const Column<double> rising = spaced(least, most, size, false, cancel);
  double low = clipped_end(orbit, rising, start, false, in.clip_radius, cancel);
  double high = clipped_end(orbit, rising, start, true, in.clip_radius, cancel);
  if (in.from > in.to) std::swap(low, high);
  return {orbit.at(spaced(low, high, size, false, cancel), cancel)};
}

struct ContourInputs : kernels::WarpSettings {
  Point point;
  Block<Generator, 1> generators;
  Vector normal;
  double length;
  bool both_ways;
  std::int64_t count;
  double clip_radius;
};

Attempt<Made<Point>> contour_points(const Context& context, const ContourInputs& in) {
  if (in.normal == Vector{}) return Failure{"degenerate", "the normal of the plane must not be zero", "normal"};
  const Attempt<std::vector<kernels::WarpSource>> sources = sources_of(context, in.generators);
  if (!sources) return sources.error();
  const kernels::Stop stop = context.cancel().for_kernels();
  const kernels::WarpField warp_field(*sources, stop);
  const Vector up = normalized(in.normal);
  kernels::WarpSettings backward = in;
  backward.strength = -in.strength;
  const auto moved = [&](const Vector& place, const kernels::WarpSettings& how) {
    Vector there;
    kernels::warp_points(warp_field, how, {&place.x, &place.y, &place.z}, {&there.x, &there.y, &there.z}, 1, stop);
    return there;
  };
  // Across the way from where the field would have come to where it goes, in the plane: of a finite displacement alone
  // the curvature of its path would be seen too.
  const DirectionField field = [&](const Vector& place) {
    const Vector across = cross(up, moved(place, in) - moved(place, backward));
    return is_finite(across) ? normalized(across) : Vector{};
  };
  const FieldLineOptions options{in.length, static_cast<std::size_t>(in.count), in.clip_radius, in.both_ways};
  const FieldLine line = field_line(field, to_vector(in.point), options, context.cancel());
  Made<Point> contour{Column<Point>(line.points.size())};
  for (std::size_t i = 0; i < line.points.size(); ++i) contour.values.set(i, to_point(line.points[i]));
  return contour;
}

RunCost cost_of_orbit(const RunSize& size) { return {60 * size.values, 40 * size.values}; }

/// Every point takes some steps, each with several looks at the field; more where the field changes fast.
RunCost cost_of_contour(const RunSize& size) {
  constexpr double looks = 200;
  const auto sources = static_cast<double>(size.consumed.front().size);
  return {size.values * looks * (60 + 14 * sources) + 50 * sources, source_bytes * sources + 56 * size.values};
}

InputSpec clip_radius_input() { return defaults(100).hard(1e-3, 1e6).soft(1, 1000).unit("m"); }

}  // namespace

void add_curves(Registry& registry) {
  registry.add(
      node("orbit", orbit_points)
          .title("Orbit")
          .family("fields")
          .synonyms({"path", "trajectory", "flow line", "streamline", "spiral", "curve"})
          .doc("Where exp(t * generator) carries a point, for t along a new axis.")
          .source("Boosted Surfaces, section 4, fig. 8")
          .version(2)
          .details(
              "Where the orbit leaves the clip radius it ends, on both sides of t = 0 (or of the end nearest to it): "
              "its points are then even in t over the part within. If it starts outside, every point is at infinity.")
          .degenerate("point at a generator", "Every point of the orbit is that point.")
          .degenerate("isoclinic generators",
                      "The two equal turns have a closed form of their own; nothing is divided by their difference.")
          .input("point", &OrbitInputs::point, "Where the orbit passes at t = 0.",
                 defaults({1, 0, 0}).unit("m").position_handle())
          .input("generator", &OrbitInputs::generator, "What moves the point.")
          .input("from", &OrbitInputs::from, "First t.", defaults(0).hard(-1e6, 1e6).soft(-4, 4).title("First t"))
          .input("to", &OrbitInputs::to, "Last t.", defaults(1).hard(-1e6, 1e6).soft(-4, 4).title("Last t"))
          .input("count", &OrbitInputs::count, "How many points.", defaults(64).hard(1, 1'000'000).soft(2, 256))
          .input("clip_radius", &OrbitInputs::clip_radius, "Distance from the origin at which the orbit ends.",
                 clip_radius_input())
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .input("rule", &OrbitInputs::rule,
                 "The true exponential, or the paper's with the scalar part of the square only.",
                 defaults("exact").title("Exponential"))
          .axes(one_axis("count", "axis"))
          .makes_curves()
          .cost(cost_of_orbit)
          .output("points", "The orbit, over the new axis."));

  registry.add(
      node("contour", contour_points)
          .title("Contour")
          .family("fields")
          .synonyms({"level set", "equipotential", "isoline", "curve"})
          .doc("The curve through a point that runs across the displacements of a field in a plane: an equipotential "
               "line.")
          .source("Boosted Surfaces, figs. 8, 9")
          .version(2)
          .details("The field moves points as warp does with the same inputs. The curve ends after its length, where "
                   "it comes back to its start, where it leaves the clip radius, and where the field gives no "
                   "direction: at a fixed point, or where points move along the normal. Its points are at even "
                   "distances over what there is; the last one of a closed curve is the first. The displacements are "
                   "finite, so a contour closes only nearly: what is missing, up to 2 % of its length, is spread over "
                   "it. A start beyond the clip radius, or without a direction, gives that one point.")
          .degenerate("point at a generator", "There is no direction: every point is the start.")
          .degenerate("zero direction", "A zero normal is an error.")
          .input("point", &ContourInputs::point, "Where the curve starts.",
                 defaults({1, 0, 0}).unit("m").position_handle())
          .input("generators", &ContourInputs::generators, "Links to one or several, or one family of them.",
                 required().several())
          .consumed_axis("over", "The axis to sum over; empty means the last of generators.")
          .input("normal", &ContourInputs::normal, "Normal of the plane of the curve.",
                 defaults({0, 0, 1}).direction_handle("point"))
          .input("length", &ContourInputs::length, "The curve is at most so long; below 0 it runs the other way.",
                 defaults(4).hard(-1e6, 1e6).soft(-10, 10).unit("m"))
          .input("both_ways", &ContourInputs::both_ways, "A curve that does not close runs to both sides of its start.",
                 defaults(false))
          .input("count", &ContourInputs::count, "How many points.", defaults(64).hard(1, 100'000).soft(2, 256))
          .input("clip_radius", &ContourInputs::clip_radius, "Distance from the origin at which the curve ends.",
                 clip_radius_input())
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .with(
              warp_settings<ContourInputs>(1e-4, 0, "Power of the distance; 0 gives every generator the same weight."))
          .lists_along("axis")
          .axes(one_axis("count", "axis"))
          .makes_curves()
          .cost(cost_of_contour)
          .output("points", "The curve, over the new axis."));
}

}  // namespace dini
