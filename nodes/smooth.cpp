#include "geometry/smooth.h"

#include "geometry/normals.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/shapes.h"

namespace dini {

namespace {

struct SmoothInputs {
  std::int64_t iterations;
  double strength;
  bool keep_volume, keep_border;
};

SharedMesh smoothed(const Context& context, const SharedMesh& shape, const SmoothInputs& in) {
  if (in.iterations == 0 || in.strength == 0) return shape;
  const SmoothOptions options{static_cast<std::size_t>(in.iterations), in.strength, in.keep_volume, in.keep_border};
  Column<Point> positions = smoothed_positions(*shape, options, context.cancel());
  if (context.cancel().stopped()) return shape;
  const std::shared_ptr<Mesh> moved =
      with_positions(context, *shape, std::move(positions), Column<Vector>(*shape->normals));
  moved->normals = smooth_normals(*moved, context.cancel());
  return moved;
}

}  // namespace

void add_smooth(Registry& registry) {
  registry.add(
      node("smooth", smoothed)
          .title("Smooth")
          .family("meshes")
          .synonyms({"relax", "fair", "blur", "laplacian", "taubin", "round off", "soften"})
          .doc("Smooths a mesh: vertices move towards the middle of their neighbors.")
          .source("Taubin, A signal processing approach to fair surface design (1995)")
          .details("Vertices at one place move together, so that seams stay closed; sharp edges become round, and "
                   "normals smooth. Without keep_volume the mesh shrinks as it gets smoother. Edges of one triangle, "
                   "or of more than two, are the border.")
          .input("shape", "The mesh.")
          .input("iterations", &SmoothInputs::iterations, "How often; 0 leaves the mesh as it is.",
                 defaults(10).hard(0, 1000).soft(0, 100))
          .input("strength", &SmoothInputs::strength,
                 "How far each time: 1 is two thirds of the way to the middle of the neighbors.",
                 defaults(0.5).hard(0, 1))
          .input("keep_volume", &SmoothInputs::keep_volume,
                 "Whether each step is followed by one back, so that bumps go and the shape stays.", defaults(true))
          .input("keep_border", &SmoothInputs::keep_border,
                 "Whether vertices on a border stay; else borders are smoothed as curves.", defaults(true))
          .cost([](const RunSize& size) {
            const double steps = static_cast<double>(integer_at(size.literals, "iterations")) *
                                 (boolean_at(size.literals, "keep_volume") ? 2 : 1);
            return RunCost{(400 + 40 * steps) * size.vertices, 240 * size.vertices};
          })
          .output("shape", "The smoother mesh."));
}

}  // namespace dini
