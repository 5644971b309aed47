#include "service/engine.h"

#include <algorithm>
#include <chrono>

#include "gltf/glb_container.h"
#include "graph/cache.h"
#include "graph/card.h"
#include "graph/check.h"
#include "graph/evaluate.h"
#include "graph/nearest.h"
#include "graph/parameters.h"
#include "graph/value_json.h"
#include "nodes/all.h"
#include "service/asset_reader.h"
#include "service/asset_store.h"
#include "service/prepared.h"
#include "service/report.h"
#include "service/single_flight.h"
#include "service/version.h"

namespace dini {

namespace {

constexpr std::size_t inspected_values = 2'000'000;

Json catalogue_of(const Registry& registry) {
  Json nodes = Json::array();
  for (const auto& [id, type] : registry.types()) nodes.push_back(card(type));
  return {{"engine", engine_version},
          {"types", wire_type_cards()},
          {"families", family_titles()},
          {"nodes", std::move(nodes)}};
}

/// The node to export: the one asked for, else the only one that makes a file.
Result<std::size_t> find_output(const Plan& plan, const std::string& asked) {
  std::vector<std::string> exports;
  for (const PlannedNode& node : plan.nodes) {
    if (!node.outputs.empty() && node.outputs.front().type == WireType::asset) exports.push_back(node.id);
  }
  std::string known;
  for (const std::string& id : exports) known += (known.empty() ? "" : ", ") + id;
  if (asked.empty()) {
    if (exports.size() == 1) return plan.index.at(exports.front());
    return Problem{
        "unknown-output",
        exports.empty() ? "the graph has no export node" : "the graph has several outputs, choose one of " + known, "",
        "", "/output"};
  }
  if (std::find(exports.begin(), exports.end(), asked) == exports.end()) {
    return Problem{"unknown-output",
                   "\"" + asked + "\" is no export node of the graph" + did_you_mean(asked, exports) +
                       (exports.empty() ? "" : "; there is " + known),
                   "", "", "/output"};
  }
  return plan.index.at(asked);
}

Result<std::shared_ptr<Prepared>> check_graph(const Registry& registry, const Limits& limits, AssetStore& assets,
                                              const Json& graph, const Json& parameters, Quality quality) {
  auto prepared = std::make_shared<Prepared>();
  Result<Document> document = read_document(graph, limits);
  if (!document) return document.problems();
  prepared->document = std::move(*document);
  Result<std::map<std::string, Json>> values = resolve_parameters(prepared->document, parameters);
  if (!values) return values.problems();
  CheckReport report = check(registry, prepared->document, *values, quality, limits, assets.finder());
  if (!report.problems.empty()) return report.problems;
  prepared->plan = std::move(report.plan);
  return prepared;
}

/// What the bytes of an answer depend on: the output's content, the checks that must pass, the parameters written into
/// the file, and the engine.
Digest entity_digest(const Prepared& prepared) {
  DigestBuilder digest;
  digest.text(engine_version);
  for (const std::size_t target : prepared.targets) digest.digest(prepared.plan.nodes[target].fingerprint);
  digest.text(prepared.extras.dump());
  return digest.finish();
}

}  // namespace

struct Engine::State {
  explicit State(const Limits& given) : limits(given), cache(given.cache_bytes), assets(given.asset_store_bytes) {
    add_all_nodes(registry);
    catalogue = catalogue_of(registry);
  }

  Limits limits;
  Registry registry;
  Json catalogue;
  mutable Cache cache;
  mutable AssetStore assets;
  mutable SingleFlight<Result<Evaluated>> flights;
};

Engine::Engine(Limits limits) : state_(std::make_unique<State>(limits)) {}
Engine::~Engine() = default;

const Limits& Engine::limits() const { return state_->limits; }

const Json& Engine::catalogue() const { return state_->catalogue; }

Result<AssetSummary> Engine::add_asset(std::string_view bytes, const std::string& name) const {
  if (!name.empty() && !AssetStore::is_name(name)) {
    return Problem{"usage", "the name of a file has 1 to 64 letters, digits, '_', '-' and '.', and is no hash"};
  }
  Result<SharedAssetFile> read = read_asset(bytes, state_->limits);
  if (!read) return read.problems();
  const AssetFile& file = **read;
  state_->assets.add(*read, name);
  return AssetSummary{to_hex(file.sha256), file.bytes, std::string(name_of(file.content.format)),
                      file.content.mesh.positions.size(), file.content.mesh.triangles.size()};
}

Json Engine::validate(const Json& graph, const Json& parameters) const {
  Problems problems;
  CheckReport report;
  if (Result<Document> document = read_document(graph, state_->limits); !document) {
    problems = document.problems();
  } else {
    std::map<std::string, Json> values;
    for (const auto& [name, parameter] : document->parameters) values[name] = parameter.default_value;
    if (Result<std::map<std::string, Json>> given = resolve_parameters(*document, parameters); given) {
      values = std::move(*given);
    } else {
      problems = given.problems();
    }
    report = check(state_->registry, *document, values, Quality::final, state_->limits, state_->assets.finder());
    problems.insert(problems.end(), report.problems.begin(), report.problems.end());
  }
  return validation_report(report, problems);
}

Result<std::shared_ptr<const Prepared>> Engine::prepare(const EvaluateRequest& request) const {
  const auto begin = std::chrono::steady_clock::now();
  Result<std::shared_ptr<Prepared>> checked =
      check_graph(state_->registry, state_->limits, state_->assets, request.graph, request.parameters, request.quality);
  if (!checked) return checked.problems();
  Prepared& prepared = **checked;
  Result<std::size_t> output = find_output(prepared.plan, request.output);
  if (!output) return output.problems();
  prepared.output = *output;
  prepared.targets.push_back(*output);
  for (std::size_t node = 0; node < prepared.plan.nodes.size(); ++node) {
    const PlannedNode& planned = prepared.plan.nodes[node];
    if (planned.type->always_evaluated && !planned.bypass) prepared.targets.push_back(node);
  }
  prepared.extras = file_extras(prepared.plan, *output);
  prepared.entity_tag = "\"" + to_hex(entity_digest(prepared)) + "\"";
  prepared.milliseconds = milliseconds_since(begin);
  return std::shared_ptr<const Prepared>(std::move(*checked));
}

const std::string& Engine::entity_tag(const Prepared& prepared) { return prepared.entity_tag; }

Result<Evaluated> Engine::evaluate(const Prepared& prepared, const Cancel& cancel) const {
  return state_->flights.run(prepared.entity_tag, cancel, [&](const Cancel& shared) -> Result<Evaluated> {
    const auto begin = std::chrono::steady_clock::now();
    Result<Evaluation> evaluation = dini::evaluate(prepared.plan, prepared.targets, state_->cache, shared);
    if (!evaluation) return evaluation.problems();
    const Value value = evaluation->value(prepared.plan, prepared.output, 0);
    if (value.column.index() != static_cast<std::size_t>(WireType::asset) || sample_count(value.axes) != 1) {
      return Problem{"axis-mismatch", "the output must be one file, it has axes",
                     prepared.plan.nodes[prepared.output].id};
    }
    const SharedAsset asset = column_of<SharedAsset>(value)[0];
    const auto run = evaluation->runs.find(prepared.output);
    Evaluated answer;
    answer.glb = std::make_shared<const std::string>(stamp_extras(asset->bytes, prepared.extras));
    answer.milliseconds = {{"prepare", prepared.milliseconds},
                           {"evaluate", milliseconds_since(begin)},
                           {"encode", run == evaluation->runs.end() ? 0 : run->second.milliseconds}};
    // Most callers want the file only, and the report of a large graph takes longer than finding it in the cache.
    answer.report = [owner = prepared.shared_from_this(), kept = std::move(*evaluation), asset, glb = answer.glb,
                     milliseconds = answer.milliseconds] {
      return evaluation_report(*owner, kept, *asset, *glb, milliseconds);
    };
    return answer;
  });
}

Result<Json> Engine::inspect(const InspectRequest& request, const Cancel& cancel) const {
  Result<std::shared_ptr<Prepared>> checked =
      check_graph(state_->registry, state_->limits, state_->assets, request.graph, request.parameters, Quality::final);
  if (!checked) return checked.problems();
  const Plan& plan = (*checked)->plan;
  const auto found = plan.index.find(request.node);
  if (found == plan.index.end()) {
    std::vector<std::string> known;
    for (const auto& [id, node] : plan.index) known.push_back(id);
    return Problem{"unknown-node", "the graph has no node \"" + request.node + "\"" + did_you_mean(request.node, known),
                   request.node, "", "/node"};
  }
  const PlannedNode& node = plan.nodes[found->second];
  std::size_t output = 0;
  if (!request.output.empty()) {
    const OutputPort* port = node.type->find_output(request.output);
    if (port == nullptr) {
      std::vector<std::string> known;
      for (const OutputPort& one : node.type->outputs) known.push_back(one.name);
      return Problem{
          "unknown-port",
          node.type->title + " has no output \"" + request.output + "\"" + did_you_mean(request.output, known),
          request.node, request.output, "/output"};
    }
    output = static_cast<std::size_t>(port - node.type->outputs.data());
  }
  if (output >= node.outputs.size()) {
    return Problem{"unknown-port", "a bypassed node has one output only", request.node, request.output, "/output"};
  }
  if (sample_count(node.outputs[output].axes) > inspected_values) {
    return Problem{"limit-exceeded",
                   "there are " + std::to_string(sample_count(node.outputs[output].axes)) + " values, at most " +
                       std::to_string(inspected_values) + " are shown",
                   request.node, request.output, "/output"};
  }
  Result<Evaluation> evaluation = dini::evaluate(plan, {found->second}, state_->cache, cancel);
  if (!evaluation) return evaluation.problems();
  return to_json(evaluation->value(plan, found->second, output), request.full);
}

Json to_json(const Problems& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems) {
    Json entry = {{"code", problem.code}, {"detail", problem.detail}};
    if (!problem.node.empty()) entry["node"] = problem.node;
    if (!problem.port.empty()) entry["port"] = problem.port;
    if (!problem.pointer.empty()) entry["pointer"] = problem.pointer;
    if (!problem.fix.is_null()) entry["fix"] = problem.fix;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace dini
