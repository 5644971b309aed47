#include "service/report.h"

#include "graph/order.h"
#include "graph/thinning.h"
#include "graph/value_json.h"
#include "service/engine.h"
#include "service/measures.h"
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
std::set<std::string> needed_nodes(const PreparedGraph& prepared) {
  std::vector<std::string> ids;
  for (const std::size_t target : prepared.targets) ids.push_back(prepared.plan.nodes[target].id);
  for (const Preview& preview : prepared.previews) {
    if (!preview.outputs.empty()) ids.push_back(prepared.plan.nodes[preview.node].id);
  }
  return needed_for(*prepared.graph->document, ids);
}

/// What every node of the evaluation said, by what it computes.
std::map<Digest, std::shared_ptr<const NodeWarnings>> warnings_of(const Evaluation& evaluation) {
  std::map<Digest, std::shared_ptr<const NodeWarnings>> said;
  for (const auto& [fingerprint, run] : evaluation.runs) {
    for (const auto& warnings : run.result->warnings) said.emplace(warnings->fingerprint, warnings);
  }
  return said;
}

void add_warnings(Json& list, const PlannedNode& node, const NodeWarnings& said) {
  for (const Warning& warning : said.warnings) {
    Json entry = {{"code", warning.code}, {"node", node.id}, {"detail", told(warning, node.consumed)}};
    if (!warning.port.empty()) entry["port"] = warning.port;
    list.push_back(std::move(entry));
  }
}

/// What the nodes of an evaluation have to tell.
struct Told {
  Json nodes = Json::object();
  Json checks = Json::array();
  Json warnings = Json::array();
};

Told told_by_nodes(const PreparedGraph& prepared, const ComputedGraph& computed, Sent sent) {
  const Plan& plan = prepared.plan;
  const std::set<std::string> needed = needed_nodes(prepared);
  const std::map<Digest, std::shared_ptr<const NodeWarnings>> said = warnings_of(computed.evaluation);
  Told told;
  for (std::size_t index = 0; index < plan.nodes.size(); ++index) {
    const PlannedNode& node = plan.nodes[index];
    const bool is_needed = needed.contains(node.id);
    const NodeRun* run = is_needed ? computed.evaluation.run(node) : nullptr;
    told.nodes[node.id] = node_json(node, run, is_needed);
    if (!is_needed || node.bypass) continue;
    if (const auto found = said.find(node.fingerprint); found != said.end()) {
      add_warnings(told.warnings, node, *found->second);
    }
    if (run != nullptr && node.type->always_evaluated) {
      const Value value = computed.evaluation.value(plan, index, 0);
      told.checks.push_back({{"node", node.id}, {"passed", true}, {"values", to_json(value)["values"]}});
    }
  }
  for (Json& problem : to_json(prepared.elsewhere, sent)) told.warnings.push_back(std::move(problem));
  if (computed.model != nullptr) {
    if (const auto warning = unkept_budget(plan, computed.model->triangles)) {
      told.warnings.push_back({{"code", warning->code}, {"node", prepared.output}, {"detail", warning->detail}});
    }
  }
  return told;
}

Json model_json(const File& model) {
  Json json = {{"bytes", model.bytes->size()},
               {"vertices", model.vertices},
               {"triangles", model.triangles},
               {"position_error", model.position_error},
               {"sha256", to_hex(model.sha256)}};
  if (const auto& errors = model.attribute_errors) {
    json["normal_error"] = errors->normal;
    json["uv_error"] = errors->uv;
    json["color_error"] = errors->color;
  }
  return json;
}

Json preview_json(const PreparedGraph& prepared, const File& file) {
  Json shown = Json::array();
  for (const Preview& preview : prepared.previews) shown.push_back(prepared.plan.nodes[preview.node].id);
  return {{"bytes", file.bytes->size()}, {"nodes", std::move(shown)}, {"sha256", to_hex(file.sha256)}};
}

}  // namespace

Json evaluation_report(const PreparedGraph& prepared, const ComputedGraph& computed, Sent sent, Extent extent) {
  Told told = told_by_nodes(prepared, computed, sent);
  Json report = {{"checks", std::move(told.checks)}, {"warnings", std::move(told.warnings)}};
  if (computed.model != nullptr) {
    report["fingerprint"] = to_hex(prepared.fingerprint);
    report["output"] = prepared.output;
    report["model"] = model_json(*computed.model);
  }
  if (!prepared.measures.empty()) report["measures"] = measures_of(prepared, computed.evaluation);
  if (computed.parts != nullptr) report["parts"] = computed.parts->list;
  if (computed.preview != nullptr) report["preview"] = preview_json(prepared, *computed.preview);
  if (extent == Extent::outcome) return report;
  std::map<std::string, double> milliseconds = computed.milliseconds;
  milliseconds.emplace("prepare", prepared.milliseconds);
  report["engine"] = engine_version;
  report["etag"] = prepared.model_tag;
  report["quality"] = prepared.plan.detail.quality == Quality::draft ? "draft" : "final";
  report["milliseconds"] = milliseconds;
  report["cost"] = cost_json(prepared.plan.cost);
  report["nodes"] = std::move(told.nodes);
  return report;
}

Json validation_report(const CheckReport& report, const Problems& problems, Sent sent) {
  Json wires = Json::object();
  for (const PlannedNode& node : report.plan.nodes) {
    for (std::size_t output = 0; output < node.outputs.size(); ++output) {
      wires[node.id + "." + node.type->outputs[output].name] = wire_json(node.outputs[output]);
    }
  }
  return {{"valid", problems.empty()},
          {"errors", to_json(problems, sent)},
          {"blocked", report.blocked},
          {"wires", std::move(wires)},
          {"cost", cost_json(report.plan.cost)}};
}

}  // namespace dini
