#include "graph/thinning.h"

#include <algorithm>

namespace dini {

namespace {

bool has_triangles(const PlannedNode& node) {
  if (node.outputs.empty()) return false;
  const WireType type = node.outputs.front().type;
  return type == WireType::mesh || type == WireType::asset;
}

double meshes_on(const WireShape& shape) {
  return static_cast<double>(std::max<std::size_t>(1, sample_count(shape.axes)));
}

/// An upper bound of the triangles of one mesh on a wire: a closed grid has two for each vertex.
double triangles_of_one(const WireShape& shape) { return 2.0 * static_cast<double>(shape.vertices) / meshes_on(shape); }

/// The predicted triangles of each mesh that a node makes, by index into the plan, and where they end up.
class Prediction {
 public:
  Prediction(const Plan& plan, const std::set<std::string>& needed) : plan_(plan), of_one_(plan.nodes.size()) {
    std::set<std::size_t> passed_on;
    for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
      const PlannedNode& node = plan.nodes[index];
      if (node.bypass || !needed.contains(node.id) || !has_triangles(node)) continue;
      ends_.insert(index);
      for (const PlannedInput& input : node.inputs) {
        for (const PlannedItem& item : input.items) {
          if (const auto* source = std::get_if<Source>(&item.from)) passed_on.insert(source->node);
        }
      }
    }
    for (const std::size_t index : passed_on) ends_.erase(index);
  }

  /// All triangles that end up somewhere, when every mesh is thinned to a `share` of its size. A mesh that is used
  /// several times, or by a family, counts as often.
  double total(double share) {
    double sum = 0;
    for (std::size_t index = 0; index < plan_.nodes.size(); ++index) {
      const PlannedNode& node = plan_.nodes[index];
      if (node.bypass || !has_triangles(node)) continue;
      of_one_[index] = thinned(node, share);
      if (ends_.contains(index)) sum += of_one_[index] * meshes_on(node.outputs.front());
    }
    return sum;
  }

  double of_one(std::size_t node) const { return of_one_[node]; }

 private:
  double thinned(const PlannedNode& node, double share) const {
    const double whole = triangles_of_one(node.outputs.front());
    if (node.type->vertex_factor) return std::clamp(share * whole, std::min(given(node), whole), whole);
    if (!node.type->makes_meshes_by_quality()) return std::min(given(node), whole);
    const auto fewest = static_cast<double>(node.type->fewest_triangles(node.consumed));
    return std::clamp(share * whole, std::min(fewest, whole), whole);
  }

  /// What the meshes that one run of a node is given have together.
  double given(const PlannedNode& node) const {
    double sum = 0;
    for (std::size_t port = 0; port < node.inputs.size(); ++port) {
      const bool all_at_once = node.overload->inputs[port].is_mixed();
      for (const PlannedItem& item : node.inputs[port].items) {
        const auto* source = std::get_if<Source>(&item.from);
        if (source != nullptr) sum += of_one_[source->node] * (all_at_once ? meshes_on(item.shape) : 1);
      }
    }
    return sum;
  }

  const Plan& plan_;
  std::set<std::size_t> ends_;  ///< nodes whose meshes or files no other needed node makes something of
  std::vector<double> of_one_;
};

}  // namespace

void share_triangles(Plan& plan, const std::set<std::string>& needed) {
  if (plan.detail.quality == Quality::final) return;
  const auto budget = static_cast<double>(plan.detail.triangle_budget);
  Prediction prediction(plan, needed);
  if (prediction.total(1) <= budget) return;
  double share = 0, too_much = 1;
  for (int step = 0; step < 40; ++step) {
    const double middle = (share + too_much) / 2;
    (prediction.total(middle) <= budget ? share : too_much) = middle;
  }
  prediction.total(share);
  for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
    PlannedNode& node = plan.nodes[index];
    if (node.bypass || !node.type->makes_meshes_by_quality()) continue;
    const double triangles = prediction.of_one(index);
    if (triangles < triangles_of_one(node.outputs.front())) {
      node.triangle_budget = std::max<std::size_t>(1, static_cast<std::size_t>(triangles));
    }
  }
}

std::optional<Warning> unkept_budget(const Plan& plan, std::size_t triangles) {
  if (plan.detail.quality == Quality::final || triangles <= plan.detail.triangle_budget) return std::nullopt;
  return Warning{"triangle-budget", "the draft has " + std::to_string(triangles) +
                                        " triangles, more than its budget of " +
                                        std::to_string(plan.detail.triangle_budget) +
                                        ": its meshes are as thin as they can be, or were cut at infinity"};
}

}  // namespace dini
