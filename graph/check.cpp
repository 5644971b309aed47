#include "graph/check.h"

#include <algorithm>
#include <set>

#include "graph/fingerprint.h"
#include "graph/infer.h"
#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/nearest.h"
#include "graph/order.h"
#include "graph/resolve.h"

namespace dini {

namespace {

template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

class Checker {
 public:
  Checker(const Registry& registry, const Document& document, const std::map<std::string, Json>& parameters,
          Quality quality, const Limits& limits, const AssetFinder& find_asset)
      : registry_(registry), document_(document), limits_(limits), find_asset_(find_asset) {
    report_.plan.parameters = parameters;
    report_.plan.quality = quality;
  }

  CheckReport run() {
    for (const auto& [id, entry] : document_.nodes) check_names(id, entry);
    const Order order = evaluation_order(document_);
    if (!order.cycle.empty()) report_cycle(order.cycle);
    for (const std::string& id : order.ids) plan(id, document_.nodes.at(id));
    find_blocked();
    add_up();
    return std::move(report_);
  }

 private:
  void add(Problem problem) {
    broken_.insert(problem.node);
    report_.problems.push_back(std::move(problem));
  }

  static std::string pointer(const std::string& node, const std::string& port = "") {
    return "/graph/nodes/" + node + (port.empty() ? "" : "/inputs/" + pointer_token(port));
  }

  /// Node types, port names and link targets: what can be wrong whatever the rest of the graph is.
  void check_names(const std::string& id, const NodeEntry& entry) {
    const NodeType* type = registry_.find(entry.type);
    if (type == nullptr) {
      const std::vector<std::string> known = keys_of(registry_.types());
      const std::string near = nearest(entry.type, known);
      Problem problem{"unknown-node-type",
                      "there is no node type " + excerpt(entry.type) + did_you_mean(entry.type, known), id, "",
                      pointer(id) + "/type"};
      if (!near.empty()) problem.fix = {{{"op", "replace"}, {"path", problem.pointer}, {"value", near}}};
      add(std::move(problem));
    }
    for (const auto& [port, input] : entry.inputs) {
      if (type != nullptr && type->find_input(port) == nullptr) report_unknown_port(*type, id, port);
      for (const InputItem& item : input.items) {
        if (const auto* link = std::get_if<Link>(&item)) check_link(id, port, *link);
        if (const auto* reference = std::get_if<ParameterReference>(&item)) check_reference(id, port, *reference);
      }
    }
  }

  void report_unknown_port(const NodeType& type, const std::string& id, const std::string& port) {
    std::vector<std::string> known;
    for (const InputPort& input : type.inputs) known.push_back(input.name);
    Problem problem{"unknown-port", type.title + " has no input " + excerpt(port) + did_you_mean(port, known), id, port,
                    pointer(id, port)};
    const std::string near = nearest(port, known);
    if (!near.empty() && !document_.nodes.at(id).inputs.contains(near)) {
      problem.fix = {{{"op", "move"}, {"from", problem.pointer}, {"path", pointer(id, near)}}};
    }
    add(std::move(problem));
  }

  void check_link(const std::string& id, const std::string& port, const Link& link) {
    const auto source = document_.nodes.find(link.node);
    if (source == document_.nodes.end()) {
      add({"dangling-link",
           "there is no node " + excerpt(link.node) + did_you_mean(link.node, keys_of(document_.nodes)), id, port,
           pointer(id, port)});
      return;
    }
    const NodeType* type = registry_.find(source->second.type);
    if (type == nullptr || link.output.empty() || type->find_output(link.output) != nullptr) return;
    std::vector<std::string> known;
    for (const OutputPort& output : type->outputs) known.push_back(output.name);
    add({"dangling-link",
         "node " + link.node + " (" + type->title + ") has no output " + excerpt(link.output) +
             did_you_mean(link.output, known),
         id, port, pointer(id, port)});
  }

  void check_reference(const std::string& id, const std::string& port, const ParameterReference& reference) {
    if (document_.parameters.contains(reference.name)) return;
    add({"unknown-parameter",
         "the graph has no parameter " + excerpt(reference.name) +
             did_you_mean(reference.name, keys_of(document_.parameters)),
         id, port, pointer(id, port)});
  }

  void report_cycle(const std::vector<std::string>& cycle) {
    constexpr std::size_t most_named = 8;
    std::string path;
    for (std::size_t i = 0; i < std::min(cycle.size(), most_named); ++i) path += cycle[i] + " -> ";
    if (cycle.size() > most_named) path += "... -> ";
    add({"graph-has-cycle", "the links form a cycle: " + path + cycle.front(), cycle.front(), "",
         pointer(cycle.front())});
  }

  /// Plans one node whose sources have all been looked at; skips it when any of them could not be planned.
  void plan(const std::string& id, const NodeEntry& entry) {
    if (broken_.contains(id)) return;
    for (const std::string& source : sources_of(entry)) {
      if (!report_.plan.index.contains(source)) return;
    }
    Resolved resolved = resolve_node(id, entry, *registry_.find(entry.type), document_, report_.plan, find_asset_);
    for (Problem& problem : resolved.problems) add(std::move(problem));
    if (broken_.contains(id)) return;
    PlannedNode& node = resolved.node;
    if (!node.bypass) {
      if (std::optional<Problem> problem = infer_axes(node, limits_)) {
        problem->pointer = pointer(id, problem->port);
        add(std::move(*problem));
        return;
      }
      node.fingerprint = fingerprint(node, report_.plan);
    }
    report_.plan.index.emplace(id, report_.plan.nodes.size());
    report_.plan.nodes.push_back(std::move(node));
  }

  void find_blocked() {
    for (const auto& [id, entry] : document_.nodes) {
      if (!report_.plan.index.contains(id) && !broken_.contains(id)) report_.blocked.push_back(id);
    }
  }

  void add_up() {
    Cost& cost = report_.plan.cost;
    for (const PlannedNode& node : report_.plan.nodes) {
      if (node.bypass) continue;
      for (const WireShape& shape : node.outputs) {
        const std::size_t samples = sample_count(shape.axes);
        constexpr std::size_t bytes_per_sample = 10 * sizeof(double);
        constexpr std::size_t bytes_per_vertex = 8 * sizeof(double) + 2 * 3 * sizeof(std::uint32_t);
        cost.samples += samples;
        cost.bytes += samples * bytes_per_sample + shape.vertices * bytes_per_vertex;
        if (shape.type == WireType::mesh) cost.vertices = std::max(cost.vertices, shape.vertices);
      }
      if (cost.bytes > limits_.request_bytes) {
        add({"limit-exceeded",
             "up to here the graph would need " + std::to_string(cost.bytes >> 20) + " MiB, at most " +
                 std::to_string(limits_.request_bytes >> 20) + " MiB are accepted",
             node.id, "", pointer(node.id)});
        return;
      }
    }
    cost.triangles = 2 * cost.vertices;
  }

  const Registry& registry_;
  const Document& document_;
  const Limits& limits_;
  const AssetFinder& find_asset_;
  CheckReport report_;
  std::set<std::string> broken_;
};

}  // namespace

CheckReport check(const Registry& registry, const Document& document, const std::map<std::string, Json>& parameters,
                  Quality quality, const Limits& limits, const AssetFinder& find_asset) {
  return Checker(registry, document, parameters, quality, limits, find_asset).run();
}

}  // namespace dini
