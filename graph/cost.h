#pragma once

#include <optional>
#include <set>
#include <string>

#include "graph/limits.h"
#include "graph/plan.h"
#include "graph/problem.h"

namespace dini {

/// What a planned node is predicted to need: a bound of its memory, and about its work.
struct NodeCost {
  double work = 0;        ///< units of about a nanosecond of one processor
  double kept_bytes = 0;  ///< of its results
  double run_bytes = 0;   ///< beside them, while it runs
};

NodeCost cost_of(const PlannedNode& node);

/// Adds up what the `running` nodes of a plan need. Results are all kept until the end. Of nodes that stand one behind
/// another only one runs at a time, all others may run at once, so the memory is a bound whatever runs beside what. The
/// first node at which a limit is passed is the problem; its pointer is left to the caller.
std::optional<Problem> add_up(Plan& plan, const std::set<std::string>& running, const Limits& limits);

/// What is said when something needs more memory, or more work, than is accepted; nothing when it does not. `what` is
/// the subject of the sentence.
std::optional<Problem> over_limits(const Cost& cost, const Limits& limits, const std::string& what);

}  // namespace dini
