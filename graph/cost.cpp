#include "graph/cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dini {

namespace {

/// At most so many runs of one function at once are counted: with more threads, results weigh more than what runs need.
constexpr double most_at_once = 32;

constexpr double node_bytes = 4096;    ///< of the bookkeeping of one node
constexpr double call_bytes = 1024;    ///< of one call of a function
constexpr double mesh_bytes = 1024;    ///< of a mesh beside its vertices and triangles
constexpr double vertex_bytes = 80;    ///< position, normal, texture coordinate and color
constexpr double triangle_bytes = 12;  ///< of which a vertex has two
constexpr double vertex_work = 100;

/// Bytes of one value of a type that is made of numbers.
double bytes_of_value(WireType type) {
  switch (type) {
    case WireType::number:
      return sizeof(double);
    case WireType::vector:
    case WireType::point:
      return 3 * sizeof(double);
    case WireType::sphere:
      return 5 * sizeof(double);
    case WireType::generator:
    case WireType::circle:
      return 10 * sizeof(double);
    case WireType::field:
      return 160;  // an operation, and its column of pointers
    default:
      return 2 * sizeof(void*);
  }
}

/// Nanoseconds for one value of a type, made by a usual function and looked at.
double work_of_value(WireType type) {
  switch (type) {
    case WireType::circle:
    case WireType::sphere:
      return 400;
    case WireType::generator:
      return 200;
    default:
      return 40;
  }
}

double samples_of(const Axes& axes) { return static_cast<double>(sample_count(axes)); }

/// What one run of a node is given and makes.
RunSize run_size(const PlannedNode& node, double runs) {
  RunSize size{node.literals, node.consumed, {}, 0, 0, 0, 0};
  for (const WireShape& shape : node.outputs) {
    if (shape.type != WireType::asset) size.vertices += static_cast<double>(shape.vertices) / runs;
    size.values += samples_of(shape.axes) / runs;
    if (shape.type == WireType::field) size.fields += samples_of(shape.axes) / runs;
  }
  for (std::size_t port = 0; port < node.inputs.size(); ++port) {
    const PlannedInput& input = node.inputs[port];
    if (!node.overload->inputs[port].is_mixed()) {
      const double meshes = std::max(1.0, samples_of(input.shape.axes));
      size.given_vertices += static_cast<double>(input.shape.vertices) / meshes;
      continue;
    }
    for (const PlannedItem& item : input.items) {
      size.given[static_cast<std::size_t>(item.shape.type)] += samples_of(item.shape.axes);
      size.given_vertices += static_cast<double>(item.shape.vertices);
    }
  }
  return size;
}

double kept_by(const WireShape& shape) {
  const double samples = samples_of(shape.axes);
  if (shape.type == WireType::asset) return samples * mesh_bytes;
  if (shape.type != WireType::mesh) return samples * bytes_of_value(shape.type);
  const auto vertices = static_cast<double>(shape.vertices);
  return samples * mesh_bytes + vertices * (vertex_bytes + 2 * triangle_bytes);
}

std::size_t to_size(double number) {
  constexpr double largest = 9e18;
  return static_cast<std::size_t>(std::min(std::ceil(number), largest));
}

}  // namespace

NodeCost cost_of(const PlannedNode& node) {
  const double runs = std::max(1.0, samples_of(node.lifted));
  const RunSize size = run_size(node, runs);
  const RunCost of_run = node.type->cost ? node.type->cost(size) : RunCost{};
  NodeCost cost;
  cost.work = runs * (vertex_work * (size.vertices + size.given_vertices) + of_run.work);
  for (const WireShape& shape : node.outputs) cost.work += samples_of(shape.axes) * work_of_value(shape.type);
  cost.kept_bytes = node_bytes + runs * of_run.kept_bytes;
  for (const WireShape& shape : node.outputs) cost.kept_bytes += kept_by(shape);
  double made_bytes = 0;  // by a run, before they are put beside those of other runs
  for (std::size_t output = 0; output < node.outputs.size(); ++output) {
    if (node.made[output].empty()) continue;
    made_bytes += samples_of(node.made[output]) * bytes_of_value(node.outputs[output].type);
  }
  cost.run_bytes = std::min(runs, most_at_once) * (of_run.bytes + made_bytes + call_bytes);
  for (std::size_t port = 0; port < node.inputs.size(); ++port) {
    const PlannedInput& input = node.inputs[port];
    if (!input.list_axis) continue;  // else its items are stacked into a column of their own
    const double values = samples_of(input.shape.axes);
    cost.run_bytes += values * bytes_of_value(input.shape.type) + node_bytes * static_cast<double>(input.items.size());
    cost.work += values * work_of_value(input.shape.type);
  }
  return cost;
}

std::optional<Problem> over_limits(const Cost& cost, const Limits& limits, const std::string& what) {
  if (cost.bytes > limits.request_bytes) {
    return Problem{"limit-exceeded", what + " would need " + std::to_string(cost.bytes >> 20) + " MiB, at most " +
                                         std::to_string(limits.request_bytes >> 20) + " MiB are accepted"};
  }
  if (cost.work > limits.work) {
    constexpr std::size_t units_per_second = 1'000'000'000;
    return Problem{"limit-exceeded", what + " would compute for about " + std::to_string(cost.work / units_per_second) +
                                         " seconds of one processor, at most " +
                                         std::to_string(limits.work / units_per_second) + " are accepted"};
  }
  return std::nullopt;
}

namespace {

/// The nodes of a plan in chains: each node stands behind the one before it in its chain, so no two of a chain run at
/// once. Any chains will do for a bound; these follow the first source that does not end in another chain yet.
class Chains {
 public:
  explicit Chains(std::size_t nodes) : chain_of_(nodes, none) {}

  /// Adds a node that needs so many bytes while it runs.
  void add(std::size_t index, const PlannedNode& node, double bytes) {
    std::size_t& chain = chain_of_[index];
    chain = chain_to_continue(node);
    if (chain == none) {
      chain = chains_.size();
      chains_.push_back({index, 0});
    }
    chains_[chain].last = index;
    const double more = std::max(0.0, bytes - chains_[chain].most);
    chains_[chain].most += more;
    total_ += more;
  }

  /// What all nodes so far can need at once.
  double total() const { return total_; }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct Chain {
    std::size_t last;
    double most;
  };

  std::size_t chain_to_continue(const PlannedNode& node) const {
    for (const PlannedInput& input : node.inputs) {
      for (const PlannedItem& item : input.items) {
        const auto* source = std::get_if<Source>(&item.from);
        if (source == nullptr) continue;
        const std::size_t chain = chain_of_[source->node];
        if (chain != none && chains_[chain].last == source->node) return chain;
      }
    }
    return none;
  }

  std::vector<std::size_t> chain_of_;
  std::vector<Chain> chains_;
  double total_ = 0;
};

}  // namespace

std::optional<Problem> add_up(Plan& plan, const std::set<std::string>& running, const Limits& limits) {
  double kept = 0, work = 0;
  Chains chains(plan.nodes.size());
  for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
    const PlannedNode& node = plan.nodes[index];
    if (node.bypass || node.doubtful || !running.contains(node.id)) continue;
    for (const WireShape& shape : node.outputs) {
      plan.cost.samples += sample_count(shape.axes);
      if (shape.type == WireType::mesh) plan.cost.vertices = std::max(plan.cost.vertices, shape.vertices);
    }
    const NodeCost cost = cost_of(node);
    kept += cost.kept_bytes;
    work += cost.work;
    chains.add(index, node, cost.run_bytes);
    plan.cost.bytes = to_size(kept + chains.total());
    plan.cost.work = to_size(work);
    if (auto problem = over_limits(plan.cost, limits, "up to here the graph")) {
      problem->node = node.id;
      return problem;
    }
  }
  plan.cost.triangles = 2 * plan.cost.vertices;
  return std::nullopt;
}

}  // namespace dini
