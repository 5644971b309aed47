#pragma once

#include <string>
#include <utility>
#include <vector>

#include "algebra/kernels.h"
#include "graph/node_builder.h"
#include "nodes/choices.h"

namespace dini {

/// The generators of a field that act, each with its position; a zero generator does nothing wherever it sits. One that
/// sits nowhere (a pure direction) is a failure, for no distance to it can be measured. Stopped early: only the first.
Attempt<std::vector<kernels::WarpSource>> sources_of(const Context& context, const Block<Generator, 1>& generators);

/// The inputs that say how the generators of a field act together, for the card of a node whose functions have the
/// struct `Inputs`, which derives from kernels::WarpSettings.
template <class Inputs>
auto warp_settings(const Json& strength, const Json& power, const std::string& power_doc) {
  return [=](auto node) {
    return std::move(node)
        .input("strength", &Inputs::strength, "Factor of the sum.", defaults(strength).hard(-1e9, 1e9).soft(-2, 2))
        .input("power", &Inputs::power, power_doc, defaults(power).hard(0, 16).soft(0, 4))
        .input("softening", &Inputs::softening, "Added to the power of the distance.",
               defaults(0).hard(0, 1e9).soft(0, 2))
        .input("rule", &Inputs::rule, "The true exponential, or the paper's with the scalar part of the square only.",
               defaults("exact").title("Exponential"))
        .input("method", &Inputs::method,
               "One rotor from the summed generators, or the sum of what each would do alone.",
               defaults("sum_generators").title("Combine by"));
  };
}

}  // namespace dini
