#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/cancel.h"
#include "graph/limits.h"
#include "graph/plan.h"
#include "graph/problem.h"
#include "graph/registry.h"

namespace dini {

/// Everything that can be said about a graph without computing: the plan, as far as it could be made, and all root
/// problems. `blocked` are the nodes that are well in themselves but stand behind one that is not.
///
/// The plan also holds broken and blocked nodes whose outputs can be told all the same; those are `doubtful`. Nodes of
/// which nothing can be told are not in it.
struct CheckReport {
  Plan plan;
  Problems problems;                 ///< of the nodes that are asked for and of what they depend on
  Problems elsewhere;                ///< of all other nodes
  std::vector<std::string> blocked;  ///< among the nodes that are asked for and what they depend on
  std::vector<std::size_t> guards;   ///< the sound nodes that run whatever is asked for, by index into the plan
};

/// What of a graph is going to be evaluated: everything, unless targets are named. With `guards`, also the nodes that
/// run whatever is asked for, where they are sound. When `cancel` stops, the check ends with what it has: the caller
/// looks at it before it believes the report.
struct CheckScope {
  std::vector<std::string> targets = {};
  bool guards = true;
  const Cancel* cancel = nullptr;
};

/// Checks ids, types, links, cycles, literals, ranges, axes, sizes and limits, all at once, finds the files that the
/// graph names, and shares the triangles of a draft. Takes time proportional to the graph.
CheckReport check(const Registry& registry, const Document& document, const ParameterValues& parameters, Detail detail,
                  const Limits& limits, const AssetFinder& find_asset = {}, const CheckScope& scope = {});

}  // namespace dini
