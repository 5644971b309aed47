// The field of a generator at points: the paper's curvature differential operator.

#include "algebra/flow.h"

#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

struct FlowInputs {
  Point point;
  Generator generator;
};

Attempt<std::tuple<Vector, Vector, double, double>> flow_of(const FlowInputs& in) {
  if (!is_finite(in.point)) return Failure{"degenerate", "the point at infinity has no velocity in space", "point"};
  const Flow flow = flow_at(in.generator, in.point);
  return std::tuple{flow.velocity, flow.acceleration, flow.curvature, flow.torsion};
}

}  // namespace

void add_flow(Registry& registry) {
  registry.add(
      node("flow", flow_of)
          .title("Flow")
          .family("fields")
          .synonyms({"velocity", "vector field", "curvature", "torsion", "derivative", "commutator"})
          .doc("How a generator moves a point at first: velocity, acceleration, and the bending of its orbit.")
          .source("Boosted Surfaces, section 7")
          .details("The derivatives, at t = 0, of the orbit of exp(t * generator) through the point. The velocity is "
                   "the commutator of generator and point, relative to the weight of the point. The point at infinity "
                   "is an error.")
          .degenerate("point at a generator", "It rests: all are 0.")
          .degenerate("zero direction", "The zero generator moves nothing: all are 0.")
          .input("point", &FlowInputs::point, "Where the field is asked for.",
                 defaults({1, 0, 0}).unit("m").title("Point").position_handle())
          .input("generator", &FlowInputs::generator, "What moves the point.", required().title("Generator"))
          .output("velocity", "Meters per unit of t.")
          .output("acceleration", "Meters per unit of t squared.")
          .output("curvature", "Of the orbit, one over its radius; 0 where the point rests.")
          .output("torsion",
                  "Of the orbit, in 1/m: above 0 it winds like a right-handed screw. 0 where it is "
                  "straight."));
}

}  // namespace dini
