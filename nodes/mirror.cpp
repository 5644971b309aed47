// A mesh together with its image in a mirror.

#include "geometry/mirror.h"

#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/mirrors.h"
#include "nodes/shapes.h"

namespace dini {

namespace {

struct MirrorInputs {
  Sphere mirror;
  double weld;
};

Attempt<SharedMesh> mesh_and_image(const Context& context, const SharedMesh& shape, const MirrorInputs& in) {
  if (std::optional<Failure> fault = fault_of_mirror(in.mirror)) return *fault;
  const Mesh both = with_mirror_image(*shape, in.mirror, in.weld, context.cancel());
  return SharedMesh(with_positions(context, both, *both.positions, *both.normals));
}

}  // namespace

void add_mirror(Registry& registry) {
  registry.add(
      node("mirror", mesh_and_image)
          .title("Mirror")
          .family("meshes")
          .synonyms({"symmetry", "symmetric", "reflect", "half", "duplicate", "butterfly"})
          .doc("A mesh together with its image in a plane or a sphere, welded where they meet.")
          .details(
              "The result is one mesh: vertices that are no farther from the mirror than weld are moved onto it and "
              "shared by both halves, so that half an object that ends at the mirror comes out closed. Where the two "
              "halves meet in a ridge of more than 60 degrees the ridge stays sharp. Triangles that lie in the mirror "
              "would be a wall between the halves and are left out. Nothing is cut: what reaches through the mirror "
              "passes through its image. For the images of other shapes there is reflect.")
          .degenerate("zero radius", "A sphere of radius zero is no mirror: an error.")
          .input("shape", "The mesh.")
          .input("mirror", &MirrorInputs::mirror, "The plane or the sphere.", required().title("Mirror"))
          .input("weld", &MirrorInputs::weld, "How near the mirror a vertex belongs to both halves.",
                 defaults(1e-6).hard(0, 1).soft(0, 0.01).unit("m").title("Weld within"))
          .vertex_factor([](const Literals&) { return std::size_t{2}; })
          .cost([](const RunSize& size) {
            return RunCost{60 * size.vertices, 130 * size.vertices};
          })
          .output("shape", "The mesh and its image."));
}

}  // namespace dini
