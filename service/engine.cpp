#include "service/engine.h"

#include <chrono>

#include "gltf/glb_container.h"
#include "graph/cache.h"
#include "graph/card.h"
#include "graph/check.h"
#include "graph/evaluate.h"
#include "graph/parameters.h"
#include "graph/value_json.h"
#include "nodes/all.h"
#include "service/asset_reader.h"
#include "service/asset_store.h"
#include "service/places.h"
#include "service/prepare.h"
#include "service/preview.h"
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

}  // namespace

struct Engine::State {
  explicit State(const Limits& given) : limits(given), cache(given.cache_bytes), assets(given.asset_store_bytes) {
    add_all_nodes(registry);
    catalogue = catalogue_of(registry);
  }

  Environment environment() const { return {registry, limits, assets.finder()}; }

  /// The file of a finished export, with what it says about itself.
  Result<SharedAsset> exported(const Prepared& prepared, const Evaluation& evaluation) const;

  /// The drawn previews, from the cache or into it. `known` is what the cache had before the evaluation.
  Result<SharedAsset> previewed(const Prepared& prepared, const Evaluation& evaluation,
                                const std::shared_ptr<const NodeResult>& known, const Cancel& cancel) const;

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

Result<AssetSummary> Engine::add_asset(std::string_view bytes, const std::string& name, const Cancel& cancel) const {
  if (!name.empty() && !AssetStore::is_name(name)) {
    return Problem{"usage", "the name of a file has 1 to 64 letters, digits, '_', '-' and '.', and is no hash"};
  }
  Result<SharedAssetFile> read = read_asset(bytes, state_->limits, cancel);
  if (!read) return read.problems();
  const AssetFile& file = **read;
  state_->assets.add(*read, name);
  return AssetSummary{.sha256 = to_hex(file.sha256),
                      .bytes = file.bytes,
                      .format = std::string(name_of(file.content.format)),
                      .vertices = file.content.mesh.positions.size(),
                      .triangles = file.content.mesh.triangles.size(),
                      .warnings = file.content.warnings};
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
  Result<std::shared_ptr<Prepared>> prepared = prepare_evaluation(state_->environment(), request);
  if (!prepared) return prepared.problems();
  return std::shared_ptr<const Prepared>(*std::move(prepared));
}

std::vector<std::string> Engine::blocked(const EvaluateRequest& request) const {
  return blocked_nodes(state_->environment(), request);
}

const std::string& Engine::entity_tag(const Prepared& prepared) { return prepared.entity_tag; }

Result<SharedAsset> Engine::State::exported(const Prepared& prepared, const Evaluation& evaluation) const {
  const Value value = evaluation.value(prepared.plan, *prepared.output, 0);
  if (value.column.index() != static_cast<std::size_t>(WireType::asset) || sample_count(value.axes) != 1) {
    return Problem{"axis-mismatch", "the output must be one file, it has axes",
                   prepared.plan.nodes[*prepared.output].id};
  }
  return column_of<SharedAsset>(value)[0];
}

Result<SharedAsset> Engine::State::previewed(const Prepared& prepared, const Evaluation& evaluation,
                                             const std::shared_ptr<const NodeResult>& known,
                                             const Cancel& cancel) const {
  if (known != nullptr) return (*std::get<SharedColumn<SharedAsset>>(known->columns.front()))[0];
  Result<std::string> drawn = draw_previews(prepared.plan, evaluation, prepared.previews, limits, cancel);
  if (!drawn) return drawn.problems();
  const std::string digest = to_hex(prepared.preview_digest);
  std::string glb = stamp_extras(*drawn, {{"engine", engine_version}, {"preview", digest}});
  const SharedAsset asset = std::make_shared<const Asset>(Asset{"model/gltf-binary", std::move(glb)});
  cache.insert(prepared.preview_digest, std::make_shared<const NodeResult>(NodeResult{{single_column(asset)}, {}}));
  return asset;
}

Result<Evaluated> Engine::evaluate(const Prepared& prepared, const Cancel& cancel) const {
  return state_->flights.run(prepared.entity_tag, cancel, [&](const Cancel& shared) -> Result<Evaluated> {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::size_t> targets = prepared.targets;
    std::shared_ptr<const NodeResult> known_preview;
    if (!prepared.previews.empty()) known_preview = state_->cache.find(prepared.preview_digest);
    if (known_preview == nullptr) {
      for (const Preview& preview : prepared.previews) {
        if (!preview.outputs.empty()) targets.push_back(preview.node);
      }
    }
    Result<Evaluation> evaluation = dini::evaluate(prepared.plan, targets, state_->cache, shared);
    if (!evaluation) return evaluation.problems();
    Evaluated answer;
    answer.milliseconds = {{"prepare", prepared.milliseconds}, {"evaluate", milliseconds_since(begin)}};
    SharedAsset model;
    if (prepared.output) {
      Result<SharedAsset> exported = state_->exported(prepared, *evaluation);
      if (!exported) return exported.problems();
      model = *exported;
      answer.glb = std::make_shared<const std::string>(stamp_extras(model->bytes, prepared.extras));
      const auto run = evaluation->runs.find(*prepared.output);
      answer.milliseconds["encode"] = run == evaluation->runs.end() ? 0 : run->second.milliseconds;
    }
    if (!prepared.previews.empty()) {
      const auto drawing = std::chrono::steady_clock::now();
      Result<SharedAsset> drawn = state_->previewed(prepared, *evaluation, known_preview, shared);
      if (!drawn) return drawn.problems();
      answer.preview = std::shared_ptr<const std::string>(*drawn, &(*drawn)->bytes);
      answer.milliseconds["preview"] = milliseconds_since(drawing);
    }
    // Most callers want the files only, and the report of a large graph takes longer than finding them in the cache.
    answer.report = [owner = prepared.shared_from_this(), kept = std::move(*evaluation), model, glb = answer.glb,
                     preview = answer.preview, milliseconds = answer.milliseconds] {
      return evaluation_report(*owner, kept, {model.get(), glb.get(), preview.get()}, milliseconds);
    };
    return answer;
  });
}

Result<Json> Engine::inspect(const InspectRequest& request, const Cancel& cancel) const {
  const Result<Plan> plan = prepare_inspection(state_->environment(), request);
  if (!plan) return plan.problems();
  const std::size_t index = plan->index.at(request.node);
  const PlannedNode& node = plan->nodes[index];
  std::size_t output = 0;
  if (!request.output.empty()) {
    const OutputPort* port = node.type->find_output(request.output);
    if (port == nullptr) return unknown_output(*node.type, request.node, request.output, "/output");
    output = static_cast<std::size_t>(port - node.type->outputs.data());
  }
  if (output >= node.outputs.size()) return bypassed_output(request.node, request.output, "/output");
  const std::size_t count = sample_count(node.outputs[output].axes);
  if (count > inspected_values) {
    return Problem{
        "limit-exceeded",
        "there are " + std::to_string(count) + " values, at most " + std::to_string(inspected_values) + " are shown",
        request.node, request.output, "/output"};
  }
  Result<Evaluation> evaluation = dini::evaluate(*plan, {index}, state_->cache, cancel);
  if (!evaluation) return evaluation.problems();
  return to_json(evaluation->value(*plan, index, output), request.full);
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
