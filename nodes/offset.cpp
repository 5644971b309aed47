#include "geometry/displacement.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/mesh_reach.h"

namespace dini {

namespace {

struct MeshOffsetInputs {
  double distance;
};

Attempt<SharedMesh> moved_along_normals(const Context& context, const SharedMesh& shape, const MeshOffsetInputs& in) {
  if (in.distance == 0) return shape;
  auto mesh = std::make_shared<const Mesh>(offset(*shape, in.distance, context.cancel()));
  if (!is_mesh_within_reach(*mesh, context.cancel())) {
    return Failure{"out-of-range", "the mesh would reach beyond 1e18 m", "distance"};
  }
  return SharedMesh(std::move(mesh));
}

}  // namespace

void add_offset(Registry& registry) {
  registry.add(
      node("offset", moved_along_normals)
          .title("Offset")
          .family("meshes")
          .synonyms({"parallel surface", "inflate", "grow", "shrink", "push"})
          .doc("A mesh moved along its normals.")
          .details(
              "Vertices at one position move as one, so that nothing opens. A smooth surface becomes its parallel "
              "one; flat faces stay flat, at the distance, and their edges stay sharp. Beyond the center of a bend "
              "the surface passes through itself: an offset of a field does not.")
          .input("shape", "The mesh.")
          .input("distance", &MeshOffsetInputs::distance, "Along the normals; below 0 against them.",
                 defaults(0.1).hard(-1e6, 1e6).soft(-0.5, 0.5).unit("m"))
          .cost([](const RunSize& size) {
            return RunCost{300 * size.given_vertices, 200 * size.given_vertices};
          })
          .output("shape", "The moved mesh."));
}

}  // namespace dini
