#include "graph/thinning.h"

#include <algorithm>

namespace dini {

namespace {

/// What a mesh keeps at least; fewer triangles show no shape at all.
constexpr double smallest_share = 32;

/// An upper bound of the triangles on a wire: a closed grid has two for each vertex.
double triangles_on(const WireShape& shape) { return 2.0 * static_cast<double>(shape.vertices); }

bool has_triangles(const PlannedNode& node) {
  if (node.outputs.empty()) return false;
  const WireType type = node.outputs.front().type;
  return type == WireType::mesh || type == WireType::asset;
}

/// The triangles where they end up: on the wires that no other needed node makes meshes or files of. A mesh that is
/// used several times, or by a family, counts as often.
double triangles_at_the_end(const Plan& plan, const std::set<std::string>& needed) {
  std::set<std::size_t> passed_on;
  for (const PlannedNode& node : plan.nodes) {
    if (!needed.contains(node.id) || !has_triangles(node)) continue;
    for (const PlannedInput& input : node.inputs) {
      for (const PlannedItem& item : input.items) {
        if (const auto* source = std::get_if<Source>(&item.from)) passed_on.insert(source->node);
      }
    }
  }
  double total = 0;
  for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
    const PlannedNode& node = plan.nodes[index];
    const bool ends = !node.bypass && needed.contains(node.id) && has_triangles(node) && !passed_on.contains(index);
    if (ends) total += triangles_on(node.outputs.front());
  }
  return total;
}

}  // namespace

void share_triangles(Plan& plan, const std::set<std::string>& needed) {
  if (plan.detail.quality == Quality::final) return;
  const double total = triangles_at_the_end(plan, needed);
  const auto budget = static_cast<double>(plan.detail.triangle_budget);
  if (total <= budget) return;
  for (PlannedNode& node : plan.nodes) {
    if (node.bypass || !node.type->makes_meshes_by_quality()) continue;
    const WireShape& shape = node.outputs.front();
    const auto meshes = static_cast<double>(std::max<std::size_t>(1, sample_count(shape.axes)));
    const double share = triangles_on(shape) / meshes * (budget / total);
    node.triangle_budget = static_cast<std::size_t>(std::max(share, smallest_share));
  }
}

}  // namespace dini
