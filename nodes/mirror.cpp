// A shape together with its image in a mirror.

#include "geometry/mirror.h"

#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/mirrors.h"
#include "nodes/more.h"
#include "nodes/shapes.h"

namespace dini {

namespace {

struct MirrorInputs {
  Sphere mirror;
  double weld;
};

template <class Element>
Attempt<Made<Element>> element_and_image(const Element& shape, const MirrorInputs& in) {
  if (std::optional<Failure> fault = fault_of_mirror(in.mirror)) return *fault;
  Made<Element> both{Column<Element>(2)};
  both.values.set(0, shape);
  both.values.set(1, reflect(in.mirror, shape));
  return both;
}

Attempt<SharedMesh> mesh_and_image(const Context& context, const SharedMesh& shape, const MirrorInputs& in) {
  if (std::optional<Failure> fault = fault_of_mirror(in.mirror)) return *fault;
  const Mesh both = with_mirror_image(*shape, in.mirror, in.weld, context.cancel());
  return SharedMesh(with_positions(context, both, *both.positions, *both.normals));
}

std::vector<Axes> axes_of_mirror(const Literals& literals, const std::string& id) {
  const std::string& name = text_at(literals, "axis");
  return {{{name.empty() ? id : name, 2, false}}};
}

}  // namespace

void add_mirror(Registry& registry) {
  registry.add(
      node("mirror", element_and_image<Point>, element_and_image<Circle>, element_and_image<Sphere>,
           element_and_image<Generator>, mesh_and_image)
          .title("Mirror")
          .family("transforms")
          .synonyms({"symmetry", "symmetric", "reflect", "half", "duplicate", "butterfly"})
          .doc("A shape together with its image in a plane or a sphere; a mesh is welded to its image.")
          .details(
              "A mesh becomes one mesh: vertices that are no farther from the mirror than weld are moved onto it and "
              "shared by both halves, so that half an object that ends at the mirror comes out closed. Where the two "
              "halves meet in a ridge of more than 60 degrees the ridge stays sharp. Triangles that lie in the mirror "
              "would be a wall between the halves and are left out. Nothing is cut: what reaches through the mirror "
              "passes through its image. Other shapes come as two values along a new axis, first the shape itself.")
          .degenerate("circle to line", "A circle through the center of a sphere has a line as its image.")
          .degenerate("zero radius", "A sphere of radius zero is no mirror: an error.")
          .input("shape", "Meshes, points, circles, spheres or generators.")
          .input("mirror", &MirrorInputs::mirror, "The plane or the sphere.", required().title("Mirror"))
          .input("weld", &MirrorInputs::weld, "How near the mirror a vertex of a mesh belongs to both halves.",
                 defaults(1e-6).hard(0, 1).soft(0, 0.01).unit("m").title("Weld within"))
          .made_axis("axis", "Name of the axis of shapes that are no meshes; empty means the id of this node.")
          .axes(axes_of_mirror)
          .vertex_factor([](const Literals&) { return std::size_t{2}; })
          .cost([](const RunSize& size) {
            return RunCost{60 * size.vertices, 130 * size.vertices};
          })
          .output("shape", "The shape and its image."));
}

}  // namespace dini
