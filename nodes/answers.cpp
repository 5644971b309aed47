#include "geometry/measure.h"
#include "graph/literal.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

std::tuple<double, double, double, double, double, double, Point, Point> measured(const Context& context,
                                                                                  const SharedMesh& model) {
  const Measures measures = measure(*model, context.cancel());
  return {measures.area,
          measures.volume,
          static_cast<double>(measures.vertices),
          static_cast<double>(measures.triangles),
          static_cast<double>(measures.euler),
          measures.diagonal,
          measures.minimum,
          measures.maximum};
}

struct CheckInputs {
  std::optional<double> minimum, maximum;
  std::string message;
};

Attempt<double> checked(double value, const CheckInputs& in) {
  if ((!in.minimum || value >= *in.minimum) && (!in.maximum || value <= *in.maximum)) return value;
  return Failure{"check-failed",
                 (in.message.empty() ? "the check failed" : in.message) + ": got " + to_text(value) + ", accepted is " +
                     range_text(in.minimum, in.maximum),
                 "value"};
}

}  // namespace

void add_answers(Registry& registry) {
  registry.add(node("measure", measured)
                   .title("Measure")
                   .family("answers")
                   .synonyms({"volume", "area", "size", "statistics", "bounding box", "weight"})
                   .doc("Area, volume, counts and bounds of a mesh.")
                   .details("The volume is enclosed only when the mesh is closed; it is signed, positive for outward "
                            "faces. Vertices are "
                            "counted by position.")
                   .input("model", "The mesh.")
                   .cost([](const RunSize& size) {
                     return RunCost{150 * size.given_vertices, 120 * size.given_vertices};
                   })
                   .output("area", "Sum of the triangles, in square meters.")
                   .output("volume", "By the divergence theorem, in cubic meters.")
                   .output("vertices", "Distinct positions in use.")
                   .output("triangles", "Triangles with three distinct corners.")
                   .output("euler", "Vertices - edges + triangles: 2 for a sphere, 0 for a torus.")
                   .output("diagonal", "Of the bounds, in meters.")
                   .output("minimum", "Least corner of the bounds.")
                   .output("maximum", "Greatest corner of the bounds."));

  registry.add(node("check", checked)
                   .title("Check")
                   .family("answers")
                   .synonyms({"assert", "test", "limit", "guard", "verify"})
                   .doc("Passes a number on when it is within bounds; fails the whole evaluation when it is not.")
                   .details("A check runs in every evaluation of its graph, whether or not the output needs it.")
                   .input("value", "The number to check.")
                   .input("minimum", &CheckInputs::minimum, "Least accepted value; none when left out.")
                   .input("maximum", &CheckInputs::maximum, "Greatest accepted value; none when left out.")
                   .input("message", &CheckInputs::message, "What to say when it fails.", defaults(""))
                   .always_evaluated()
                   .output("value", "The same number."));
}

}  // namespace dini
