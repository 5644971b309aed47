#include "graph/check.h"

#include <algorithm>
#include <set>

#include "graph/cost.h"
#include "graph/fingerprint.h"
#include "graph/fixes.h"
#include "graph/groups.h"
#include "graph/infer.h"
#include "graph/literal.h"
#include "graph/names.h"
#include "graph/nearest.h"
#include "graph/order.h"
#include "graph/origins.h"
#include "graph/resolve.h"
#include "graph/thinning.h"

namespace dini {

namespace {

class Checker {
 public:
  Checker(const Registry& registry, const Document& document, const ParameterValues& parameters, Detail detail,
          const Limits& limits, const AssetFinder& find_asset, const CheckScope& scope)
      : registry_(registry), document_(document), limits_(limits), find_asset_(find_asset), scope_(scope) {
    report_.plan.parameters = parameters;
    report_.plan.detail = detail;
    needed_ = needed_for(document, scope.targets.empty() ? keys_of(document.nodes) : scope.targets);
  }

  CheckReport run() {
    for (const auto& [id, entry] : document_.nodes) check_names(id, entry);
    const Order order = evaluation_order(document_);
    for (const std::vector<std::string>& cycle : order.cycles) report_cycle(cycle);
    for (const std::string& id : order.ids) {
      if (stopped()) return std::move(report_);
      plan(id, document_.nodes.at(id));
    }
    find_blocked();
    find_guards();
    share_triangles(report_.plan, needed_);
    find_origins(report_.plan, document_);
    for (PlannedNode& node : report_.plan.nodes) {
      if (!node.bypass && !node.doubtful) node.fingerprint = fingerprint(node, report_.plan);
    }
    if (std::optional<Problem> problem = add_up(report_.plan, counted(), limits_)) {
      problem->pointer = input_pointer(problem->node, "");
      problems_.add(*std::move(problem));
    }
    report_.problems = placed(std::move(problems_).take(), document_);
    report_.elsewhere = placed(std::move(elsewhere_).take(), document_);
    return std::move(report_);
  }

 private:
  bool stopped() const { return scope_.cancel != nullptr && scope_.cancel->stopped(); }

  /// Problems of a node, or what makes one when it is to be listed.
  template <class Found>
  void add(const std::string& node, Found found) {
    broken_.insert(node);
    (needed_.contains(node) ? problems_ : elsewhere_).add(std::move(found));
  }

  /// Node types, port names and link targets: what can be wrong whatever the rest of the graph is.
  void check_names(const std::string& id, const NodeEntry& entry) {
    const NodeType* type = registry_.find(entry.type);
    if (type == nullptr) add(id, [&] { return unknown_type(id, entry); });
    for (const auto& [port, input] : entry.inputs) {
      if (type != nullptr && type->find_input(port) == nullptr) {
        add(id, [&, &name = port] { return unknown_port(*type, id, name); });
      }
      for (std::size_t item = 0; item < input.items.size(); ++item) {
        if (stopped()) return;
        check_item(id, port, input, item);
      }
    }
  }

  void check_item(const std::string& id, const std::string& port, const InputEntry& input, std::size_t item) {
    if (const auto* link = std::get_if<Link>(&input.items[item])) check_link(id, port, input, item, *link);
    const auto* reference = std::get_if<ParameterReference>(&input.items[item]);
    if (reference != nullptr && !document_.parameters.contains(reference->name)) {
      add(id, [&] { return unknown_parameter(id, port, item_pointer(id, port, input, item), *reference); });
    }
  }

  Problem unknown_type(const std::string& id, const NodeEntry& entry) const {
    const std::vector<std::string> known = keys_of(registry_.types());
    const std::string near = nearest(entry.type, known);
    Problem problem{"unknown-node-type",
                    "there is no node type " + excerpt(entry.type) + did_you_mean(entry.type, known), id, "",
                    input_pointer(id, "") + "/type"};
    if (!near.empty()) problem.fix = replacement(*problem.pointer, near);
    return problem;
  }

  Problem unknown_port(const NodeType& type, const std::string& id, const std::string& port) const {
    const std::vector<std::string> known = all_names(type.inputs);
    Problem problem{"unknown-port", type.title + " has no input " + excerpt(port) + did_you_mean(port, known), id, port,
                    input_pointer(id, port)};
    const std::string near = nearest(port, known);
    if (!near.empty() && !document_.nodes.at(id).inputs.contains(near)) {
      problem.fix = {{{"op", "move"}, {"from", *problem.pointer}, {"path", input_pointer(id, near)}}};
    } else {
      problem.fix = {{{"op", "remove"}, {"path", *problem.pointer}}};
    }
    return problem;
  }

  void check_link(const std::string& id, const std::string& port, const InputEntry& input, std::size_t item,
                  const Link& link) {
    const auto source = document_.nodes.find(link.node);
    if (source == document_.nodes.end()) {
      add(id, [&] { return unknown_source(id, port, input, item, link); });
      return;
    }
    const NodeType* type = registry_.find(source->second.type);
    if (type == nullptr || link.output.empty() || type->find_output(link.output) != nullptr) return;
    add(id, [&] { return unknown_output(id, port, input, item, link, *type); });
  }

  Problem unknown_source(const std::string& id, const std::string& port, const InputEntry& input, std::size_t item,
                         const Link& link) const {
    const std::vector<std::string> known = keys_of(document_.nodes);
    const std::string near = nearest(link.node, known);
    const std::string output = link.output.empty() ? "" : "." + link.output;
    return {"dangling-link",
            "there is no node " + excerpt(link.node) + did_you_mean(link.node, known),
            id,
            port,
            input_pointer(id, port),
            near.empty() || near == id ? item_removal(id, port, input, item)
                                       : replacement(item_pointer(id, port, input, item) + "/from", near + output)};
  }

  Problem unknown_output(const std::string& id, const std::string& port, const InputEntry& input, std::size_t item,
                         const Link& link, const NodeType& type) const {
    const std::vector<std::string> known = all_names(type.outputs);
    const std::string near = nearest(link.output, known);
    return {"dangling-link",
            "node " + link.node + " (" + type.title + ") has no output " + excerpt(link.output) +
                did_you_mean(link.output, known),
            id,
            port,
            input_pointer(id, port),
            near.empty() ? item_removal(id, port, input, item)
                         : replacement(item_pointer(id, port, input, item) + "/from", link.node + "." + near)};
  }

  Problem unknown_parameter(const std::string& id, const std::string& port, const std::string& place,
                            const ParameterReference& reference) const {
    const std::vector<std::string> known = keys_of(document_.parameters);
    const std::string near = nearest(reference.name, known);
    return {"unknown-parameter",
            "the graph has no parameter " + excerpt(reference.name) + did_you_mean(reference.name, known),
            id,
            port,
            input_pointer(id, port),
            near.empty() ? Json() : replacement(place + "/parameter", near)};
  }

  void report_cycle(const std::vector<std::string>& cycle) {
    add(cycle.front(), [&] {
      constexpr std::size_t most_named = 8;
      std::string path;
      for (std::size_t i = 0; i < std::min(cycle.size(), most_named); ++i) path += cycle[i] + " -> ";
      if (cycle.size() > most_named) path += "... -> ";
      const std::string& first = cycle.front();
      return Problem{"graph-has-cycle",
                     "the links form a cycle: " + path + first,
                     first,
                     "",
                     input_pointer(first, ""),
                     link_removal(first, document_.nodes.at(first), cycle.back())};
    });
  }

  /// Plans one node whose sources have all been looked at; skips it when nothing is known of one of them.
  void plan(const std::string& id, const NodeEntry& entry) {
    if (broken_.contains(id)) return;
    bool doubtful = false;
    for (const std::string* source : sources_of(entry)) {
      const auto found = report_.plan.index.find(*source);
      if (found == report_.plan.index.end()) return;
      doubtful = doubtful || report_.plan.nodes[found->second].doubtful;
    }
    Resolved resolved = resolve_node(id, entry, *registry_.find(entry.type), document_, report_.plan, find_asset_);
    const bool sound = resolved.problems.empty();
    const bool can_be_told = outputs_can_be_told(resolved);
    if (!sound) add(id, std::move(resolved.problems));
    if (!can_be_told) return;
    PlannedNode& node = resolved.node;
    if (!node.bypass) {
      if (std::optional<Problem> problem = infer_axes(node, limits_)) {
        problem->pointer = input_pointer(id, problem->port);
        // Behind a broken node axes may be missing, so this may be a consequence.
        if (sound && !doubtful) add(id, [&] { return *std::move(problem); });
        return;
      }
    }
    node.doubtful = doubtful || !sound;
    report_.plan.index.emplace(id, report_.plan.nodes.size());
    report_.plan.nodes.push_back(std::move(node));
  }

  /// Whether types and axes of a node's outputs follow from what is known of its inputs.
  static bool outputs_can_be_told(const Resolved& resolved) {
    if (resolved.problems.empty()) return true;
    const PlannedNode& node = resolved.node;
    if (node.overload == nullptr) return false;
    if (node.type->overloads.size() > 1 && resolved.first_input_is_wrong) return false;
    // Axes and sizes are made from literals.
    for (std::size_t port = 0; port < node.inputs.size(); ++port) {
      const InputSlot& slot = node.overload->inputs[port];
      const bool literal = !slot.is_mixed() && info(slot.type).literal_only;
      if (literal && !node.literals.contains(node.type->inputs[port].name)) return false;
    }
    return true;
  }

  bool is_sound(const std::string& id) const {
    const auto found = report_.plan.index.find(id);
    return found != report_.plan.index.end() && !report_.plan.nodes[found->second].doubtful;
  }

  void find_blocked() {
    for (const std::string& id : needed_) {
      if (!is_sound(id) && !broken_.contains(id)) report_.blocked.push_back(id);
    }
  }

  void find_guards() {
    if (!scope_.guards) return;
    for (std::size_t index = 0; index < report_.plan.nodes.size(); ++index) {
      const PlannedNode& node = report_.plan.nodes[index];
      if (node.type->always_evaluated && !node.bypass && !node.doubtful) report_.guards.push_back(index);
    }
  }

  /// Everything that is going to run.
  std::set<std::string> counted() const {
    std::vector<std::string> ids(needed_.begin(), needed_.end());
    for (const std::size_t guard : report_.guards) ids.push_back(report_.plan.nodes[guard].id);
    return needed_for(document_, ids);
  }

  const Registry& registry_;
  const Document& document_;
  const Limits& limits_;
  const AssetFinder& find_asset_;
  const CheckScope& scope_;
  CheckReport report_;
  ProblemCollector problems_;
  ProblemCollector elsewhere_;
  std::set<std::string> needed_;
  std::set<std::string> broken_;
};

}  // namespace

CheckReport check(const Registry& registry, const Document& document, const ParameterValues& parameters, Detail detail,
                  const Limits& limits, const AssetFinder& find_asset, const CheckScope& scope) {
  return Checker(registry, document, parameters, detail, limits, find_asset, scope).run();
}

}  // namespace dini
