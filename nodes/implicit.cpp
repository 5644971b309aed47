// Solids as scalar fields, and what is done with them. nodes/implicit_surface.cpp makes meshes of them.

#include <cmath>

#include "algebra/extract.h"
#include "geometry/field_blend.h"
#include "geometry/field_offset.h"
#include "geometry/field_shapes.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/moved_field.h"
#include "nodes/wall_side.h"

namespace dini {

enum class Combination { unite, intersect, subtract };
template <>
struct ChoiceNames<Combination> {
  static constexpr std::array<std::string_view, 3> names = {"union", "intersection", "difference"};
};

namespace {

struct SolidInputs {
  bool inverted;
};

Attempt<SharedField> solid(const Sphere& shape, const SolidInputs& in) {
  const std::optional<SphereCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no sphere and no plane", "shape"};
  SharedField field = found->plane ? plane_field(found->normal, found->distance)
                                   : sphere_field(to_vector(found->center), found->radius);
  return in.inverted ? complement_field(std::move(field)) : field;
}

struct AroundInputs {
  double distance, blend;
};

Attempt<SharedField> around_circle(const Circle& shape, const AroundInputs& in) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle and no line", "shape"};
  if (found->line) return rod_field(to_vector(found->point), found->direction, in.distance);
  return ring_field(to_vector(found->center), found->normal, found->radius, in.distance);
}

Attempt<SharedField> around_points(const Context& context, const Block<Point, 1>& shape, const AroundInputs& in) {
  constexpr double farthest = 1e9;
  Column<Point> centers(shape.size());
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < shape.size() && !steps.stopped(); ++i) {
    const Point place = shape(i);
    if (!is_finite(place) || length(to_vector(place)) > farthest) {
      return Failure{"at-infinity", "point " + std::to_string(i) + " is too far away for a ball around it", "shape"};
    }
    centers.set(i, place);
  }
  return balls_field(std::move(centers), in.distance, in.blend, context.cancel());
}

struct CombineInputs {
  Block<SharedField, 1> fields;
  Combination operation;
  double blend;
};

Attempt<SharedField> combined(const CombineInputs& in) {
  if (in.fields.size() >= ScalarField::most_operations) {
    return Failure{"limit-exceeded",
                   "there are " + std::to_string(in.fields.size()) + " fields, at most " +
                       std::to_string(ScalarField::most_operations - 1) +
                       " are accepted; around takes any number of points",
                   "fields"};
  }
  std::vector<SharedField> fields;
  FieldSize size;
  for (std::size_t i = 0; i < in.fields.size(); ++i) {
    const bool subtracted = in.operation == Combination::subtract && i > 0;
    fields.push_back(subtracted ? complement_field(in.fields(i)) : in.fields(i));
    size.operations += fields.back()->size().operations;
    if (size.operations > ScalarField::most_operations) {
      return Failure{"limit-exceeded", *too_large(size), "fields"};
    }
  }
  return accepted(in.operation == Combination::unite ? union_field(std::move(fields), in.blend)
                                                     : intersection_field(std::move(fields), in.blend),
                  "fields");
}

struct OffsetInputs {
  double distance;
};

Attempt<SharedField> grown(const SharedField& shape, const OffsetInputs& in) {
  return accepted(offset_field(shape, in.distance), "shape");
}

struct ShellInputs {
  double thickness;
  WallSide side;
};

Attempt<SharedField> wall(const SharedField& shape, const ShellInputs& in) {
  const double inside = in.side == WallSide::inside ? in.thickness : in.side == WallSide::both ? 0.5 * in.thickness : 0;
  return accepted(shell_field(shape, in.thickness, inside), "shape");
}

struct FieldAtInputs {
  Point point;
};

/// A field of many points takes milliseconds for one place, so each looks at the flag.
std::tuple<double, Vector> looked_up(const Context& context, const SharedField& shape, const FieldAtInputs& in) {
  constexpr double farthest = 1e9;
  if (context.cancel().stopped()) return {0, {}};
  if (!is_finite(in.point) || length(to_vector(in.point)) > farthest) return {0, {}};
  const Slope slope = shape->slope(to_vector(in.point));
  const bool finite = std::isfinite(slope.value) && is_finite(slope.gradient);
  return finite ? std::tuple(slope.value, slope.gradient) : std::tuple(0.0, Vector{});
}

/// A field is some hundred bytes more than its wire counts; of points it has a copy, and a mesher has eight more of
/// what is left of them in parts of its box.
RunCost cost_of_field(const RunSize& size) {
  double points = 0;
  for (const Axis& axis : size.consumed) points += static_cast<double>(axis.size);
  return {20 * points, 0, 240 + 200 * points};
}

}  // namespace

void add_implicit(Registry& registry) {
  registry.add(
      node("solid", solid)
          .title("Solid")
          .family("implicit")
          .synonyms({"implicit sphere", "half space", "signed distance", "field"})
          .doc("The inside of a sphere, or what is behind a plane, as a field.")
          .details("The field is the distance from the shape, below zero inside. Behind a plane is where its normal "
                   "comes from. Transforms carry fields as they carry shapes. A sphere of radius zero is a field "
                   "without a solid.")
          .input("shape", "The sphere or plane.")
          .input("inverted", &SolidInputs::inverted, "All the rest of space instead.", defaults(false))
          .cost(cost_of_field)
          .output("field", "The field."));

  registry.add(
      node("around", around_circle, around_points)
          .title("Around")
          .family("implicit")
          .synonyms({"implicit torus", "metaballs", "thick curve", "point cloud"})
          .doc("Everything within a distance of a circle, of a line or of points, as a field.")
          .details(
              "A torus around a circle, a cylinder around a line, balls around points. Balls that are near one "
              "another are joined smoothly as blend says; those at one place act as one without a blend, and swell a "
              "little with one. Around a circle of radius zero there is a ball.")
          .input("shape", "A circle or line, or points over an axis.")
          .input("distance", &AroundInputs::distance, "How far the solid reaches around the shape.",
                 defaults(0.2).hard(1e-6, 1e6).soft(0.01, 1).unit("m"))
          .input("blend", &AroundInputs::blend, "How near to one another balls begin to flow together; for points.",
                 defaults(0).hard(0, 1e6).soft(0, 1).unit("m"))
          .consumed_axis("over", "The axis of the points; empty means the last.")
          .cost(cost_of_field)
          .output("field", "The field."));

  registry.add(
      node("combine_fields", combined)
          .title("Combine fields")
          .family("implicit")
          .synonyms({"boolean", "smooth union", "csg", "difference", "intersection"})
          .doc("The union, intersection or difference of solids, with sharp or round seams.")
          .details(
              "With a blend b the value v of fields d is the one with sum max(0, v + b - d)^2 = b^2: two planes at "
              "a right angle are joined by a fillet of radius b, the order does not matter, and what is b or more "
              "away from the surface of the others is as it was. A difference is what is in the first field and "
              "in none of the others.")
          .input("fields", &CombineInputs::fields, "Links to one or several, or one family of them.",
                 required().several())
          .consumed_axis("over", "The axis to combine over; empty means the last of fields.")
          .input("operation", &CombineInputs::operation, "What is made of them.", defaults("union"))
          .input("blend", &CombineInputs::blend, "Radius of the fillet along the seams; 0 leaves them sharp.",
                 defaults(0).hard(0, 1e6).soft(0, 1).unit("m"))
          .cost(cost_of_field)
          .output("field", "The field."));

  registry.add(
      node("offset_field", grown)
          .title("Offset field")
          .family("implicit")
          .synonyms({"grow", "shrink", "inflate"})
          .doc("A solid grown on all sides, or shrunk.")
          .details("Exact as far as the field is the distance from its surface: for shapes everywhere, elsewhere near "
                   "the surface.")
          .input("shape", "The field.")
          .input("distance", &OffsetInputs::distance, "Outward; below 0 inward.",
                 defaults(0.1).hard(-1e6, 1e6).soft(-0.5, 0.5).unit("m"))
          .cost(cost_of_field)
          .output("shape", "The field of the other size."));

  registry.add(node("shell_field", wall)
                   .title("Shell field")
                   .family("implicit")
                   .synonyms({"hollow", "wall", "thicken"})
                   .doc("The wall along the surface of a solid.")
                   .input("shape", "The field.")
                   .input("thickness", &ShellInputs::thickness, "Of the wall.",
                          defaults(0.1).hard(1e-6, 1e6).soft(0.01, 0.5).unit("m"))
                   .input("side", &ShellInputs::side, "On which side of the surface it is.", defaults("inside"))
                   .cost(cost_of_field)
                   .output("shape", "The field of the wall."));

  registry.add(node("field_at", looked_up)
                   .title("Field at")
                   .family("implicit")
                   .synonyms({"signed distance", "probe", "gradient"})
                   .doc("The value of a field at points, and the direction in which it grows.")
                   .details("Beyond 1e9 m, and at infinity, both are zero.")
                   .input("shape", "The field.")
                   .input("point", &FieldAtInputs::point, "Where.", defaults({0, 0, 0}).unit("m").position_handle())
                   .output("value", "Below zero inside; near the surface the distance from it.")
                   .output("gradient", "Of length one near the surface; zero where the field has none."));
}

}  // namespace dini
