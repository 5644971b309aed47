// Reflections: the one transform of every shape that no versor of the other transforms makes.

#include "algebra/construct.h"
#include "algebra/reflection.h"
#include "geometry/chunks.h"
#include "geometry/mirror.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/costs.h"
#include "nodes/mirrors.h"
#include "nodes/shapes.h"

namespace dini {

namespace {

struct PlaneInputs {
  Point point;
  Vector normal;
};

Attempt<Sphere> plane_element(const PlaneInputs& in) {
  if (in.normal == Vector{}) return Failure{"degenerate", "the normal of a plane must not be zero", "normal"};
  return plane_from(in.point, in.normal);
}

struct ReflectInputs {
  Sphere mirror;
};

std::optional<Failure> reflect_points(const Batch<Point>& shape, const ReflectInputs& in, BatchOut<Point> out) {
  if (std::optional<Failure> fault = fault_of_mirror(in.mirror)) return fault;
  for (std::size_t i = 0; i < out.size; ++i) out.set(i, reflect(in.mirror, shape[i]));
  return std::nullopt;
}

template <class Element>
Attempt<Element> reflect_element(const Element& shape, const ReflectInputs& in) {
  if (std::optional<Failure> fault = fault_of_mirror(in.mirror)) return *fault;
  return reflect(in.mirror, shape);
}

Attempt<SharedMesh> reflect_mesh(const Context& context, const SharedMesh& shape, const ReflectInputs& in) {
  if (std::optional<Failure> fault = fault_of_mirror(in.mirror)) return *fault;
  const Cancel& cancel = context.cancel();
  Column<Point> positions(shape->positions.size());
  Column<Vector> normals(shape->normals.size());
  for_chunks(cancel, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point place = shape->positions[i];
      positions.set(i, reflect(in.mirror, place));
      if (normals.empty()) continue;
      normals.set(i, reflected_normal(in.mirror, shape->normals[i], place));
    }
  });
  const std::shared_ptr<Mesh> reflected = with_positions(context, *shape, std::move(positions), std::move(normals));
  if (cancel.stopped()) return SharedMesh(reflected);
  // A reflection turns what runs counter-clockwise into what runs clockwise.
  NumberList<std::array<std::uint32_t, 3>> turned(reflected->triangles.size());
  for_chunks(cancel, turned.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto [a, b, c] = reflected->triangles[t];
      turned[t] = {a, c, b};
    }
  });
  reflected->triangles = std::move(turned);
  return SharedMesh(reflected);
}

}  // namespace

void add_reflect(Registry& registry) {
  registry.add(node("plane", plane_element)
                   .title("Plane")
                   .family("elements")
                   .synonyms({"mirror plane", "flat", "half space"})
                   .doc("An oriented plane: a sphere through infinity. Whatever takes a sphere takes it.")
                   .degenerate("zero direction", "A zero normal is an error.")
                   .input("point", &PlaneInputs::point, "A point on it.",
                          defaults({0, 0, 0}).unit("m").title("Point on it").position_handle())
                   .input("normal", &PlaneInputs::normal, "Its normal, of any length.",
                          defaults({0, 0, 1}).title("Normal").direction_handle("point"))
                   .output("sphere", "The plane, as a sphere through infinity."));

  registry.add(
      node("reflect", reflect_points, reflect_element<Circle>, reflect_element<Sphere>, reflect_element<Generator>,
           reflect_mesh)
          .title("Reflect")
          .family("transforms")
          .synonyms({"mirror", "inversion", "invert", "flip", "symmetry"})
          .doc("Reflects a shape in a plane, or inverts it in a sphere.")
          .source(
              "Boosted Surfaces, section 2; Dorst, Fontijne and Mann, Geometric Algebra for Computer Science (2007)")
          .details("Twice is the identity. In a sphere the center goes to infinity and infinity to the center; circles "
                   "through the center become lines. Triangles are wound the other way, so that the outside of a mesh "
                   "stays its outside; of a mesh around the center of the sphere what was outside is then within. "
                   "Triangles that reach infinity are left out with a warning. A reflected generator moves the "
                   "reflected shape as it moved the shape.")
          .degenerate("circle to line",
                      "A circle through the center of the sphere becomes a line, and a line a circle.")
          .degenerate("zero radius", "A sphere of radius zero is no mirror: an error.")
          .input("shape", "Points, circles, spheres, generators or meshes.")
          .input("mirror", &ReflectInputs::mirror, "The plane or the sphere.", required().title("Mirror"))
          .cost(cost_of_moved_mesh)
          .output("shape", "The reflected shape."));
}

}  // namespace dini
