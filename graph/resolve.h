#pragma once

#include <string>

#include "graph/plan.h"
#include "graph/problem.h"

namespace dini {

/// A node with its function chosen and every input read, or the problems with its inputs.
struct Resolved {
  PlannedNode node;
  ProblemCollector problems;
  bool first_input_is_wrong = false;  ///< so which function is meant cannot be told
};

/// Reads the inputs of one node: picks the overload that fits what is wired to it, reads literals, follows bypasses,
/// applies defaults, finds files. Every source of the node is in `plan` already; port names, links and parameters
/// exist.
Resolved resolve_node(const std::string& id, const NodeEntry& entry, const NodeType& type, const Document& document,
                      const Plan& plan, const AssetFinder& find_asset);

}  // namespace dini
