// Copies in a row, and around an axis.

#include "nodes/all.h"
#include "nodes/copies.h"

namespace dini {

namespace {

constexpr double radians_of_degree = 3.14159265358979323846 / 180;

struct ArrayInputs {
  Vector step;
  std::int64_t count;
};

template <class Shape>
struct InRow {
  static Attempt<Made<Shape>> make(const Context& context, const Shape& shape, const ArrayInputs& in) {
    return moved_copies(context, shape, static_cast<std::size_t>(in.count),
                        [&](std::size_t i) { return translation_versor(static_cast<double>(i) * in.step); });
  }
};

struct ArrayAroundInputs {
  Circle axis;
  std::int64_t count;
  double angle;
  bool closed;
};

template <class Shape>
struct Around {
  static Attempt<Made<Shape>> make(const Context& context, const Shape& shape, const ArrayAroundInputs& in) {
    const std::optional<CircleCoordinates> found = coordinates(in.axis);
    if (!found || !found->line) return Failure{"degenerate", "the axis must be a line", "axis_line"};
    const auto count = static_cast<std::size_t>(in.count);
    const auto steps = static_cast<double>(in.closed ? count : std::max<std::size_t>(1, count - 1));
    return moved_copies(context, shape, count, [&](std::size_t i) {
      return screw_motor(in.axis, static_cast<double>(i) / steps * in.angle * radians_of_degree, 0);
    });
  }
};

}  // namespace

void add_array(Registry& registry) {
  registry.add(copying_node<InRow>("array")
                   .title("Array")
                   .synonyms({"copies", "repeat", "row", "duplicate", "linear array", "pattern", "instances"})
                   .doc("Copies of a shape in a row, along a new axis.")
                   .details("The first is the shape where it is, each further one a step on. An array of an array is a "
                            "lattice; merge makes one mesh of meshes.")
                   .degenerate("zero direction", "All copies are at one place.")
                   .input("shape", "Points, circles, spheres, generators, meshes or fields.")
                   .input("step", &ArrayInputs::step, "From one copy to the next.",
                          defaults({1, 0, 0}).unit("m").direction_handle())
                   .input("count", &ArrayInputs::count, "How many, the shape itself included.",
                          defaults(5).hard(1, 10'000).soft(1, 50))
                   .made_axis("axis", "Name of the axis; empty means the id of this node.")
                   .axes(one_axis("count", "axis"))
                   .output("shape", "The copies, over the new axis."));

  registry.add(
      copying_node<Around>("array_around")
          .title("Array around")
          .synonyms({"polar array", "radial", "circular pattern", "ring of copies", "rotate copies", "instances"})
          .doc("Copies of a shape around a line, along a new axis.")
          .details("The first is the shape where it is. A closed array spreads the angle over as many steps as there "
                   "are copies, so that a full turn does not repeat its start; an open one has its last copy at the "
                   "angle.")
          .degenerate("circle to line", "A circle as axis is an error; one that has become a line is an axis.")
          .input("shape", "Points, circles, spheres, generators, meshes or fields.")
          .input("axis_line", &ArrayAroundInputs::axis, "The line to turn about.", required().title("Line"))
          .input("count", &ArrayAroundInputs::count, "How many, the shape itself included.",
                 defaults(6).hard(1, 10'000).soft(1, 50))
          .input("angle", &ArrayAroundInputs::angle, "The turn of the whole array, right hand.",
                 defaults(360).soft(-360, 360).unit("deg"))
          .input("closed", &ArrayAroundInputs::closed, "Whether the last copy is followed by the first.",
                 defaults(true))
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(one_axis("count", "axis", "closed"))
          .output("shape", "The copies, over the new axis."));
}

}  // namespace dini
