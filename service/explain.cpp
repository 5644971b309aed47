#include "service/explain.h"

#include <algorithm>
#include <set>

#include "graph/cost.h"
#include "graph/value_json.h"

namespace dini {
namespace {

/// What is looked at for every node.
struct Outlook {
  const Plan& plan;
  std::set<Digest> running;  ///< by fingerprint: what several nodes compute runs once
  std::set<Digest> known;
  std::optional<ParameterValues> before;  ///< parameters of the last evaluation of this graph
  const History& history;
};

bool has_changed(const Outlook& outlook, const std::string& parameter) {
  if (!outlook.before) return false;
  const auto before = outlook.before->find(parameter), now = outlook.plan.parameters.find(parameter);
  return before == outlook.before->end() || now == outlook.plan.parameters.end() ||
         before->second.written != now->second.written;
}

/// Why a node has to run: its result was let go, a parameter at its inputs changed, what it reads runs, or none of
/// these, so that it is new.
Json reasons(const Outlook& outlook, const PlannedNode& node) {
  if (outlook.history.was_computed(node.fingerprint)) return {{{"because", "evicted"}}};
  std::set<std::string> parameters, upstream;
  for (const PlannedInput& input : node.inputs) {
    for (const std::string& parameter : input.parameters) {
      if (has_changed(outlook, parameter)) parameters.insert(parameter);
    }
    for (const PlannedItem& item : input.items) {
      const auto* source = std::get_if<Source>(&item.from);
      if (source == nullptr) continue;
      const PlannedNode& read = outlook.plan.nodes[standing_at(outlook.plan, source->node)];
      if (outlook.running.contains(read.fingerprint)) upstream.insert(read.id);
    }
  }
  Json why = Json::array();
  for (const std::string& parameter : parameters) why.push_back({{"because", "parameter"}, {"name", parameter}});
  for (const std::string& id : upstream) why.push_back({{"because", "upstream"}, {"name", id}});
  if (why.empty()) why.push_back({{"because", "new"}});
  return why;
}

Json outputs_of(const PlannedNode& node) {
  Json outputs = Json::object();
  for (std::size_t output = 0; output < node.outputs.size(); ++output) {
    const WireShape& shape = node.outputs[output];
    outputs[node.type->outputs[output].name] = {{"type", name(shape.type)},
                                                {"axes", to_json(shape.axes)},
                                                {"vertices", shape.vertices},
                                                {"most_vertices", shape.most_vertices}};
  }
  return outputs;
}

Json explained(const Outlook& outlook, const PlannedNode& node) {
  const bool runs = outlook.running.contains(node.fingerprint);
  Json json = {{"type", node.type->id},
               {"state", runs                                       ? "runs"
                         : outlook.known.contains(node.fingerprint) ? "known"
                                                                    : "skipped"},
               {"outputs", outputs_of(node)}};
  if (!runs) return json;
  const NodeCost cost = cost_of(node);
  json["why"] = reasons(outlook, node);
  json["bytes"] = static_cast<std::uint64_t>(cost.kept_bytes + cost.run_bytes);
  json["work"] = static_cast<std::uint64_t>(cost.work);
  json["milliseconds"] = cost.work * outlook.history.milliseconds_per_unit(node.type->id);
  return json;
}

}  // namespace

Json explanation(const PreparedGraph& prepared, const std::vector<std::size_t>& targets, const Cache& cache,
                 const History& history) {
  const Plan& plan = prepared.plan;
  const Foreseen foreseen = foresee(plan, targets, cache);
  Outlook outlook{plan, {}, {}, history.last_parameters(prepared.graph->hash), history};
  double work = 0, milliseconds = 0;
  for (const std::size_t index : foreseen.running) {
    const PlannedNode& node = plan.nodes[index];
    outlook.running.insert(node.fingerprint);
    work += cost_of(node).work;
    milliseconds += cost_of(node).work * history.milliseconds_per_unit(node.type->id);
  }
  for (const std::size_t index : foreseen.known) outlook.known.insert(plan.nodes[index].fingerprint);
  Json nodes = Json::object();
  for (const PlannedNode& node : plan.nodes) nodes[node.id] = explained(outlook, node);
  return {{"runs", foreseen.running.size()},
          {"known", foreseen.known.size()},
          {"work", static_cast<std::uint64_t>(work)},
          {"milliseconds", milliseconds},
          {"bytes", foreseen.running.empty() ? 0 : prepared.bytes},
          {"nodes", std::move(nodes)}};
}

}  // namespace dini
