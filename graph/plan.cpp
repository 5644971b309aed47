#include "graph/plan.h"

namespace dini {

std::size_t standing_at(const Plan& plan, std::size_t node) {
  while (plan.nodes[node].bypass) node = std::get<Source>(plan.nodes[node].bypass->from).node;
  return node;
}

std::set<std::string> parameters_behind(const Plan& plan, std::size_t node) {
  std::set<std::string> parameters;
  std::vector<bool> seen(plan.nodes.size());
  std::vector<std::size_t> stack = {node};
  const auto visit = [&](const PlannedItem& item) {
    if (const auto* source = std::get_if<Source>(&item.from)) stack.push_back(source->node);
  };
  while (!stack.empty()) {
    const std::size_t at = stack.back();
    stack.pop_back();
    if (seen[at]) continue;
    seen[at] = true;
    const PlannedNode& planned = plan.nodes[at];
    if (planned.bypass) visit(*planned.bypass);
    for (const PlannedInput& input : planned.inputs) {
      parameters.insert(input.parameters.begin(), input.parameters.end());
      for (const PlannedItem& item : input.items) visit(item);
    }
  }
  return parameters;
}

}  // namespace dini
