#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

struct AddInputs {
  Block<Generator, 1> generators;
  Block<double, 1> weights;
};

Generator weighted_sum(const Context& context, const AddInputs& in) {
  Generator sum;
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < in.generators.size() && !steps.stopped(); ++i) {
    sum = sum + in.weights(i) * in.generators(i);
  }
  return sum;
}

struct InterpolateInputs {
  Generator a, b;
  std::optional<Generator> c, d;
  double u, v;
};

Attempt<Generator> interpolated(const InterpolateInputs& in) {
  if (in.c.has_value() != in.d.has_value()) {
    return Failure{"required-input-missing", "c and d are given together for a bilinear blend, or both left out",
                   in.c.has_value() ? "d" : "c"};
  }
  const Generator first = (1 - in.u) * in.a + in.u * in.b;
  if (!in.c) return first;
  return (1 - in.v) * first + in.v * ((1 - in.u) * *in.c + in.u * *in.d);
}

}  // namespace

void add_generators(Registry& registry) {
  registry.add(node("add", weighted_sum)
                   .title("Add")
                   .family("generators")
                   .synonyms({"sum", "combine", "mix", "plus", "total"})
                   .doc("The weighted sum of generators, along one axis.")
                   .source("Boosted Surfaces, section 4.1")
                   .input("generators", &AddInputs::generators, "Links to one or several, or one family of them.",
                          required().several())
                   .input("weights", &AddInputs::weights, "A weight for each, or one for all.",
                          defaults(1).soft(-2, 2).several())
                   .consumed_axis("over", "The axis to sum over; empty means the last of generators.")
                   .output("generator", "The sum."));

  registry.add(
      node("interpolate", interpolated)
          .title("Interpolate")
          .family("generators")
          .synonyms({"blend", "mix", "lerp", "morph", "between", "tween"})
          .doc("Blends two generators linearly, or four bilinearly.")
          .source("Boosted Surfaces, section 4.1, eq. (15)")
          .details(
              "a stands at (u, v) = (0, 0), b at (1, 0), c at (0, 1), d at (1, 1). Without c and d, v has no effect.")
          .input("a", &InterpolateInputs::a, "Generator at u = 0, v = 0.", required().title("At u 0, v 0"))
          .input("b", &InterpolateInputs::b, "Generator at u = 1, v = 0.", required().title("At u 1, v 0"))
          .input("c", &InterpolateInputs::c, "Generator at u = 0, v = 1.", required().title("At u 0, v 1"))
          .input("d", &InterpolateInputs::d, "Generator at u = 1, v = 1.", required().title("At u 1, v 1"))
          .input("u", &InterpolateInputs::u, "Position from a to b.", defaults(0.5).soft(0, 1))
          .input("v", &InterpolateInputs::v, "Position from a to c.", defaults(0.5).soft(0, 1))
          .output("generator", "The blend."));
}

}  // namespace dini
