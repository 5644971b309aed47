#include "geometry/angle.h"
#include "geometry/chunks.h"
#include "geometry/sampling.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

struct HelixInputs {
  Point center;
  Vector direction;
  double radius;
  std::optional<double> end_radius;
  double pitch, turns;
  std::int64_t count;
};

Attempt<Made<Point>> helix_points(const Context& context, const HelixInputs& in) {
  if (in.direction == Vector{}) return Failure{"degenerate", "the direction of a helix must not be zero", "direction"};
  const Vector up = normalized(in.direction);
  const Vector start = any_perpendicular(up), ahead = cross(up, start);
  const auto count = static_cast<std::size_t>(in.count);
  const double last = in.end_radius.value_or(in.radius);
  const Column<double> turns = spaced(0, in.turns, count, false, context.cancel());
  const Column<double> radii = spaced(in.radius, last, count, false, context.cancel());
  Made<Point> made{Column<Point>(count)};
  for_chunks(context.cancel(), count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const SineCosine turn = sine_cosine(turns[i]);
      const Vector outward = turn.cosine * start + turn.sine * ahead;
      const Vector place = to_vector(in.center) + (in.pitch * turns[i]) * up + radii[i] * outward;
      made.values.set(i, is_finite(place) ? to_point(place) : Point::at_infinity());
    }
  });
  return made;
}

}  // namespace

void add_helix(Registry& registry) {
  registry.add(
      node("helix", helix_points)
          .title("Helix")
          .family("sampling")
          .synonyms({"spring", "coil", "screw", "spiral", "thread", "stairs", "corkscrew"})
          .doc("Points of a helix along a new axis: a curve that climbs while it turns.")
          .details(
              "A right-hand screw; with a pitch below 0 a left-hand one, downwards. With another radius at the end "
              "it is a conical one, and flat with pitch 0: the spiral of Archimedes. It starts at a fixed "
              "direction that depends on its own. Points are even in the turn.")
          .degenerate("zero direction", "A zero direction is an error.")
          .degenerate("zero radius", "Points on the straight axis.")
          .input("center", &HelixInputs::center, "Where its axis starts.",
                 defaults({0, 0, 0}).unit("m").position_handle())
          .input("direction", &HelixInputs::direction, "Direction of its axis, of any length.",
                 defaults({0, 0, 1}).direction_handle("center"))
          .input("radius", &HelixInputs::radius, "Distance from the axis, at the start.",
                 defaults(1).hard(0, 1e6).soft(0, 4).unit("m").radius_handle("center", "direction"))
          .input("end_radius", &HelixInputs::end_radius,
                 "Distance from the axis at the end; as at the start when left "
                 "out.",
                 required().hard(0, 1e6).soft(0, 4).unit("m").title("Radius at the end"))
          .input("pitch", &HelixInputs::pitch, "How far it climbs in one turn.",
                 defaults(0.5).hard(-1e6, 1e6).soft(-2, 2).unit("m"))
          .input("turns", &HelixInputs::turns, "How often it turns; below 0 it runs the other way from its start.",
                 defaults(3).hard(-1e6, 1e6).soft(0, 20))
          .input("count", &HelixInputs::count, "How many points.", defaults(256).hard(1, 1'000'000).soft(2, 1024))
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(one_axis("count", "axis"))
          .makes_curves()
          .cost([](const RunSize& size) {
            return RunCost{40 * size.values, 16 * size.values};
          })
          .output("points", "The helix, over the new axis."));
}

}  // namespace dini
