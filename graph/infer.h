#pragma once

#include <optional>

#include "graph/limits.h"
#include "graph/plan.h"
#include "graph/problem.h"

namespace dini {

/// Works out the axes of a node whose inputs are known: names the axes of lists, finds the consumed axes, unites the
/// rest, adds the made ones, and bounds sizes. Fills `lifted`, `consumed`, `made`, `outputs` and the shapes of inputs.
/// The problem, if any, names node and port; its pointer is left to the caller.
std::optional<Problem> infer_axes(PlannedNode& node, const Limits& limits);

}  // namespace dini
