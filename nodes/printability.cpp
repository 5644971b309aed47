#include "geometry/solid_facts.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/costs.h"

namespace dini {

namespace {

struct PrintabilityInputs {
  std::int64_t most_intersections;
};

std::tuple<double, double, double, double, double, Point, Vector, Vector> judged(const Context& context,
                                                                                 const SharedMesh& model,
                                                                                 const PrintabilityInputs& in) {
  const SolidFacts facts = solid_facts(*model, static_cast<std::size_t>(in.most_intersections), context.cancel());
  return {facts.sound.watertight ? 1.0 : 0.0,
          static_cast<double>(facts.sound.borders),
          static_cast<double>(facts.sound.components),
          static_cast<double>(facts.contacts),
          facts.least_thickness,
          to_point(facts.mass.center),
          facts.mass.inertia,
          facts.mass.products};
}

}  // namespace

void add_printability(Registry& registry) {
  registry.add(
      node("printability", judged)
          .title("Printability")
          .family("answers")
          .synonyms({"watertight", "manifold", "self intersection", "thickness", "center of mass", "inertia", "holes"})
          .doc("Whether a mesh can be printed: is it closed, does it meet itself, how thin is it, where is its center.")
          .details(
              "Vertices at one position count as one. Pairs of triangles that meet are decided exactly: those that "
              "cross, touch, lie on one another or are folded back, beside edges and corners that both have. The "
              "thickness is measured from the middle of each triangle straight inward to one that faces the other way. "
              "Center and inertia are those of the enclosed solid with density 1. A mesh without triangles is not "
              "watertight, and its numbers are 0.")
          .input("model", "The mesh.")
          .input("most_intersections", &PrintabilityInputs::most_intersections,
                 "Pairs of triangles that meet are counted up to this many.",
                 defaults(1000).hard(1, 1'000'000).soft(1, 10'000))
          .cost([](const RunSize& size) {
            return RunCost{work_of_solid_facts * size.given_vertices, bytes_of_solid_facts * size.given_vertices};
          })
          .output("watertight", "1 when each edge has two triangles that run along it in opposite directions, else 0.")
          .output("boundary_loops", "Borders: closed loops of edges with one triangle.")
          .output("components", "Pieces that do not hang together.")
          .output("self_intersections", "Pairs of triangles that meet.")
          .output("least_thickness", "Of the thinnest wall, in meters; 0 where nothing is opposite.")
          .output("center_of_mass", "Of the solid.")
          .output("inertia", "Moments about x, y and z through the center, in m^5: times the density kg m^2.")
          .output("products", "The integrals of y z, z x and x y about the center, in m^5."));
}

}  // namespace dini
