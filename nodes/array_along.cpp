// Copies along a curve.

#include "geometry/curve_frames.h"
#include "graph/kept_axes.h"
#include "nodes/all.h"
#include "nodes/copies.h"
#include "nodes/curve_points.h"

namespace dini {

template <>
struct ChoiceNames<FrameRule> {
  static constexpr std::array<std::string_view, 3> names = {"steady", "curvature", "upright"};
};

namespace {

struct AlongInputs {
  Block<Point, 1> curve;
  FrameRule frames;
  Vector up;
};

/// The motion that takes the axes of space to a frame: a turn, then a translation. The turn is the quaternion of the
/// matrix whose columns are the directions (Shepperd, Quaternion from rotation matrix, 1978).
Versor motion_to(const PlacedFrame& frame) {
  const auto& [place, x, y, z] = frame;
  const double trace = x.x + y.y + z.z;
  double w;
  Vector axis;
  if (trace >= x.x && trace >= y.y && trace >= z.z) {
    w = 1 + trace;
    axis = {y.z - z.y, z.x - x.z, x.y - y.x};
  } else if (x.x >= y.y && x.x >= z.z) {
    w = y.z - z.y;
    axis = {1 + x.x - y.y - z.z, x.y + y.x, x.z + z.x};
  } else if (y.y >= z.z) {
    w = z.x - x.z;
    axis = {x.y + y.x, 1 + y.y - z.z - x.x, y.z + z.y};
  } else {
    w = x.y - y.x;
    axis = {x.z + z.x, y.z + z.y, 1 + z.z - x.x - y.y};
  }
  const double size = std::sqrt(w * w + squared_length(axis));
  Versor turn;
  turn.scalar = w / size;
  turn.bivector.e_e = (-1 / size) * axis;
  return compose(translation_versor(place), turn);
}

template <class Shape>
struct Along {
  static Attempt<Made<Shape>> make(const Context& context, const Shape& shape, const AlongInputs& in) {
    Attempt<Column<Point>> points = points_of_curve(
        context, in.curve, "curve", " of the curve is at infinity or beyond 1e18 m, where nothing can be placed");
    if (!points) return points.error();
    const Polyline curve{*std::move(points), in.curve.axis().closed};
    const std::vector<PlacedFrame> frames = curve_frames(curve, in.frames, in.up, context.cancel());
    return moved_copies(context, shape, in.curve.size(),
                        [&](std::size_t i) { return i < frames.size() ? motion_to(frames[i]) : Versor{}; });
  }
};

}  // namespace

void add_array_along(Registry& registry) {
  registry.add(
      copying_node<Along>("array_along")
          .title("Array along")
          .synonyms({"copies on curve", "path array", "follow path", "instances", "sweep copies", "beads", "fence"})
          .doc("A copy of a shape at each point of a curve, turned with the curve.")
          .source("Wang, Juettler, Zheng and Liu, Computation of rotation minimizing frames (2008)")
          .details("The origin of the shape comes to the point, its x axis along the curve. Steady frames turn about "
                   "the curve as little as they can, and start with the z axis as near to up as it can be; around a "
                   "closed curve the turn that is left is spread evenly. With curvature the z axis points to the "
                   "center of curvature; straight parts go on as they came. Upright copies have their z axis up, and "
                   "only their heading follows the curve. The copies run over the axis of the curve, so that numbers "
                   "over that axis go with them.")
          .degenerate("coincident points", "Repeated points have one frame; around one place nothing turns.")
          .degenerate("zero direction", "A zero up counts as the direction of z.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("curve", &AlongInputs::curve, "The points, over one axis.", required().title("Curve"))
          .input("frames", &AlongInputs::frames, "How copies turn about the curve.", defaults("steady").title("Frames"))
          .input("up", &AlongInputs::up, "What is up.", defaults({0, 0, 1}).direction_handle().title("Up"))
          .consumed_axis("over", "The axis of the curve; empty means the last.")
          .axes([](const Literals&, const std::string&) { return std::vector<Axes>{{kept_axes()}}; })
          .cost([](const RunSize& size) {
            const RunCost copies = cost_of_copies(size);
            return RunCost{400 * size.values, copies.bytes + 400 * size.values, copies.kept_bytes};
          })
          .output("shape", "The copies, over the axis of the curve."));
}

}  // namespace dini
