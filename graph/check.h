#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/limits.h"
#include "graph/plan.h"
#include "graph/problem.h"
#include "graph/registry.h"

namespace dini {

/// Everything that can be said about a graph without computing: the plan, as far as it could be made, and all root
/// problems. `blocked` are the nodes that are well in themselves but stand behind one that is not; the plan lacks those
/// and the broken ones.
struct CheckReport {
  Plan plan;
  Problems problems;
  std::vector<std::string> blocked;
};

/// Checks ids, types, links, cycles, literals, ranges, axes, sizes and limits, all at once, and finds the files that
/// the graph names. Takes time proportional to the graph.
CheckReport check(const Registry& registry, const Document& document, const std::map<std::string, Json>& parameters,
                  Quality quality, const Limits& limits, const AssetFinder& find_asset = {});

}  // namespace dini
