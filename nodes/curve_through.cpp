// Smooth curves through given points.

#include "geometry/spline.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/curve_points.h"

namespace dini {

template <>
struct ChoiceNames<SplineKind> {
  static constexpr std::array<std::string_view, 2> names = {"centripetal", "smooth"};
};

template <>
struct ChoiceNames<SplineSpacing> {
  static constexpr std::array<std::string_view, 2> names = {"length", "points"};
};

namespace {

struct CurveInputs {
  Block<Point, 1> points;
  SplineKind kind;
  SplineSpacing spacing;
  bool closed;
  std::int64_t count;
};

Attempt<Made<Point>> curve_through(const Context& context, const CurveInputs& in) {
  const Attempt<Column<Point>> given =
      points_of_curve(context, in.points, "points", " is at infinity or beyond 1e18 m, where no curve can go");
  if (!given) return given.error();
  const SplineOptions options{in.kind, in.spacing, in.closed, static_cast<std::size_t>(in.count)};
  return Made<Point>{spline_points(*given, options, context.cancel())};
}

}  // namespace

void add_curve_through(Registry& registry) {
  registry.add(
      node("curve", curve_through)
          .title("Curve through points")
          .family("sampling")
          .synonyms({"spline", "interpolate curve", "catmull rom", "smooth curve", "path", "bezier", "freehand"})
          .doc("Points of the smooth curve through given points, along a new axis.")
          .source("Yuksel, Schaefer and Keyser, Parameterization and applications of Catmull-Rom curves (2011)")
          .details("A centripetal curve changes only near a point that is moved, and makes no loops between "
                   "neighbors; a smooth one has a continuous curvature as well, and none at open ends. Points are at "
                   "even lengths of the curve; with spacing by points there are as many between each two neighbors as "
                   "between others, and the given ones are among them where the count is a multiple of the gaps "
                   "(plus one for an open curve). Whether the curve is closed is said here, not by the axis of the "
                   "points.")
          .degenerate("coincident points", "A repeated point counts once; if all agree, every point is that one.")
          .input("points", &CurveInputs::points, "The points to go through, over one axis or as a list.",
                 required().several())
          .input("kind", &CurveInputs::kind, "How the curve gets from point to point.", defaults("centripetal"))
          .input("closed", &CurveInputs::closed, "Whether the curve goes on from the last point to the first.",
                 defaults(false))
          .input("count", &CurveInputs::count, "How many points of the curve.",
                 defaults(128).hard(1, 1'000'000).soft(2, 512))
          .input("spacing", &CurveInputs::spacing, "Points at even lengths, or as many between all given neighbors.",
                 defaults("length"))
          .consumed_axis("over", "The axis of the points; empty means the last.")
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(one_axis("count", "axis", "closed"))
          .makes_curves()
          .cost([](const RunSize& size) {
            const auto points = static_cast<double>(size.consumed.front().size);
            return RunCost{40 * size.values + 2000 * points, 8 * size.values + 1000 * points};
          })
          .output("points", "The curve, over the new axis."));
}

}  // namespace dini
