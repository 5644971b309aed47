#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

Generator weighted_sum(const Context& context, const Block<Generator, 1>& generators, const Block<double, 1>& weights,
                       const std::string&) {
  Generator sum;
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < generators.size() && !steps.stopped(); ++i) sum = sum + weights(i) * generators(i);
  return sum;
}

Attempt<Generator> interpolated(const Generator& a, const Generator& b, const std::optional<Generator>& c,
                                const std::optional<Generator>& d, double u, double v) {
  if (c.has_value() != d.has_value()) {
    return Failure{"required-input-missing", "c and d are given together for a bilinear blend, or both left out",
                   c.has_value() ? "d" : "c"};
  }
  const Generator first = (1 - u) * a + u * b;
  if (!c) return first;
  return (1 - v) * first + v * ((1 - u) * *c + u * *d);
}

}  // namespace

void add_generators(Registry& registry) {
  registry.add(
      node("add", weighted_sum)
          .title("Add")
          .family("generators")
          .doc("The weighted sum of generators, along one axis.")
          .source("Boosted Surfaces, section 4.1")
          .input("generators", "Links to one or several, or one family of them.", required().several())
          .input("weights", "A weight for each, or one for all.", defaults(1).soft(-2, 2).several())
          .input("over", "The axis to sum over; empty means the last of generators.", defaults("").names_axis())
          .over({"over"})
          .output("generator", "The sum."));

  registry.add(
      node("interpolate", interpolated)
          .title("Interpolate")
          .family("generators")
          .doc("Blends two generators linearly, or four bilinearly.")
          .source("Boosted Surfaces, section 4.1, eq. (15)")
          .details(
              "a stands at (u, v) = (0, 0), b at (1, 0), c at (0, 1), d at (1, 1). Without c and d, v has no effect.")
          .input("a", "Generator at u = 0, v = 0.")
          .input("b", "Generator at u = 1, v = 0.")
          .input("c", "Generator at u = 0, v = 1.")
          .input("d", "Generator at u = 1, v = 1.")
          .input("u", "Position from a to b.", defaults(0.5).soft(0, 1))
          .input("v", "Position from a to c.", defaults(0.5).soft(0, 1))
          .output("generator", "The blend."));
}

}  // namespace dini
