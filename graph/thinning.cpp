#include "graph/thinning.h"

#include <algorithm>

namespace dini {

namespace {

/// What a mesh keeps at least; fewer triangles show no shape at all.
constexpr double smallest_share = 32;

/// An upper bound of the triangles on a wire: a closed grid has two for each vertex.
double triangles_on(const WireShape& shape) { return 2.0 * static_cast<double>(shape.vertices); }

bool may_be_thinned(const PlannedNode& node) { return !node.bypass && node.type->makes_meshes_by_quality(); }

}  // namespace

void share_triangles(Plan& plan, const std::set<std::string>& needed) {
  if (plan.detail.quality == Quality::final) return;
  double total = 0;
  for (const PlannedNode& node : plan.nodes) {
    if (may_be_thinned(node) && needed.contains(node.id)) total += triangles_on(node.outputs.front());
  }
  const auto budget = static_cast<double>(plan.detail.triangle_budget);
  if (total <= budget) return;
  for (PlannedNode& node : plan.nodes) {
    if (!may_be_thinned(node)) continue;
    const WireShape& shape = node.outputs.front();
    const auto meshes = static_cast<double>(std::max<std::size_t>(1, sample_count(shape.axes)));
    const double share = triangles_on(shape) / meshes * (budget / total);
    node.triangle_budget = static_cast<std::size_t>(std::max(share, smallest_share));
  }
}

}  // namespace dini
