#include "service/report.h"

#include "graph/order.h"
#include "graph/thinning.h"
#include "graph/value_json.h"
#include "service/engine.h"
#include "service/version.h"

namespace dini {

namespace {

Json wire_json(const WireShape& shape) { return {{"type", name(shape.type)}, {"axes", to_json(shape.axes)}}; }

/// `needed` is false for a node that nothing asked for.
Json node_json(const PlannedNode& node, const NodeRun* run, bool needed) {
  Json outputs = Json::object();
  for (std::size_t output = 0; output < node.outputs.size(); ++output) {
    outputs[node.type->outputs[output].name] = wire_json(node.outputs[output]);
  }
  // A node that did not have to run stands behind a cached one.
  return {{"type", node.type->id},
          {"milliseconds", run != nullptr ? run->milliseconds : 0.0},
          {"cached", needed && (run == nullptr || run->cached)},
          {"outputs", std::move(outputs)}};
}

/// What the graph was predicted to need.
Json cost_json(const Cost& cost) {
  return {{"samples", cost.samples},
          {"vertices", cost.vertices},
          {"triangles", cost.triangles},
          {"bytes", cost.bytes},
          {"work", cost.work}};
}

/// Everything that had to run, or stands behind what is cached.
std::set<std::string> needed_nodes(const Prepared& prepared) {
  std::vector<std::string> ids;
  for (const std::size_t target : prepared.targets) ids.push_back(prepared.plan.nodes[target].id);
  for (const Preview& preview : prepared.previews) {
    if (!preview.outputs.empty()) ids.push_back(prepared.plan.nodes[preview.node].id);
  }
  return needed_for(prepared.document, ids);
}

void add_warnings(Json& warnings, const PlannedNode& node, const NodeResult& result) {
  for (const Warning& warning : result.warnings) {
    Json entry = {{"code", warning.code}, {"node", node.id}, {"detail", told(warning, node.consumed)}};
    if (!warning.port.empty()) entry["port"] = warning.port;
    warnings.push_back(std::move(entry));
  }
}

}  // namespace

Json file_extras(const Plan& plan, std::size_t output) {
  const PlannedNode& node = plan.nodes[output];
  Json parameters = Json::object();
  for (const std::string& parameter : node.parameters) parameters[parameter] = plan.parameters.at(parameter);
  return {{"engine", engine_version}, {"graph", to_hex(node.fingerprint)}, {"parameters", std::move(parameters)}};
}

Json evaluation_report(const Prepared& prepared, const Evaluation& evaluation, const AnswerFiles& files,
                       const std::map<std::string, double>& milliseconds) {
  const Plan& plan = prepared.plan;
  const std::set<std::string> needed = needed_nodes(prepared);
  Json nodes = Json::object();
  Json warnings = Json::array();
  Json checks = Json::array();
  for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
    const PlannedNode& node = plan.nodes[index];
    const auto found = evaluation.runs.find(index);
    const NodeRun* run = found == evaluation.runs.end() ? nullptr : &found->second;
    nodes[node.id] = node_json(node, run, needed.contains(node.id));
    if (run == nullptr) continue;
    add_warnings(warnings, node, *run->result);
    if (node.type->always_evaluated) {
      const Value value = evaluation.value(plan, index, 0);
      checks.push_back({{"node", node.id}, {"passed", true}, {"values", to_json(value)["values"]}});
    }
  }
  for (const BrokenCheck& broken : prepared.broken_checks) {
    checks.push_back({{"node", broken.node}, {"passed", false}, {"message", broken.reason}});
  }
  for (Json& problem : to_json(prepared.elsewhere)) warnings.push_back(std::move(problem));
  if (files.model != nullptr) {
    if (const auto warning = unkept_budget(plan, files.model->triangles)) {
      warnings.push_back(
          {{"code", warning->code}, {"node", plan.nodes[*prepared.output].id}, {"detail", warning->detail}});
    }
  }
  Json report = {{"engine", engine_version},
                 {"etag", prepared.entity_tag},
                 {"quality", plan.detail.quality == Quality::draft ? "draft" : "final"},
                 {"milliseconds", milliseconds},
                 {"cost", cost_json(plan.cost)},
                 {"nodes", std::move(nodes)},
                 {"checks", std::move(checks)},
                 {"warnings", std::move(warnings)}};
  if (files.model != nullptr) {
    report["fingerprint"] = to_hex(plan.nodes[*prepared.output].fingerprint);
    report["output"] = plan.nodes[*prepared.output].id;
    report["model"] = {{"bytes", files.glb->size()},
                       {"vertices", files.model->vertices},
                       {"triangles", files.model->triangles},
                       {"position_error", files.model->position_error},
                       {"sha256", to_hex(sha256(*files.glb))}};
  }
  if (files.preview != nullptr) {
    Json shown = Json::array();
    for (const Preview& preview : prepared.previews) shown.push_back(plan.nodes[preview.node].id);
    report["preview"] = {
        {"bytes", files.preview->size()}, {"nodes", std::move(shown)}, {"sha256", to_hex(sha256(*files.preview))}};
  }
  return report;
}

Json validation_report(const CheckReport& report, const Problems& problems) {
  Json wires = Json::object();
  for (const PlannedNode& node : report.plan.nodes) {
    for (std::size_t output = 0; output < node.outputs.size(); ++output) {
      wires[node.id + "." + node.type->outputs[output].name] = wire_json(node.outputs[output]);
    }
  }
  return {{"valid", problems.empty()},
          {"errors", to_json(problems)},
          {"blocked", report.blocked},
          {"wires", std::move(wires)},
          {"cost", cost_json(report.plan.cost)}};
}

}  // namespace dini
