#include "service/catalogue_engine.h"

#include <array>
#include <chrono>

#include "graph/card.h"
#include "graph/check.h"
#include "graph/evaluate.h"
#include "graph/groups.h"
#include "graph/parameters.h"
#include "graph/stopped.h"
#include "graph/value_json.h"
#include "nodes/all.h"
#include "nodes/editor_hints.h"
#include "nodes/formats.h"
#include "service/document_graph.h"
#include "service/explain.h"
#include "service/interface.h"
#include "service/places.h"
#include "service/preview.h"
#include "service/shared_form.h"
#include "service/version.h"

namespace dini {

namespace {

constexpr std::size_t inspected_values = 2'000'000;

Json card(const FileFormat& format) {
  return {{"name", format.name},
          {"media_types", format.media_types},
          {"extension", format.extension},
          {"description", format.doc}};
}

/// What cards called things before they took the names of documents: clients that read those go on until version 0.3.
void add_old_names(Json& described) {
  constexpr std::array<std::pair<const char*, const char*>, 5> names = {{{"doc", "description"},
                                                                         {"minimum", "min"},
                                                                         {"maximum", "max"},
                                                                         {"soft_minimum", "soft_min"},
                                                                         {"soft_maximum", "soft_max"}}};
  for (const auto& [before, now] : names) {
    if (described.contains(now)) described[before] = described[now];
  }
}

Json card_for_all(const NodeType& type) {
  Json described = card(type);
  add_editor_hints(described);
  add_old_names(described);
  for (const char* const ports : {"inputs", "outputs"}) {
    for (Json& port : described[ports]) add_old_names(port);
  }
  return described;
}

Json catalogue_of(const Registry& registry, std::span<const FileFormat> formats) {
  Json nodes = Json::array(), written = Json::array(), types = wire_type_cards();
  for (const FileFormat& format : formats) written.push_back(card(format));
  for (const auto& [id, type] : registry.types()) nodes.push_back(card_for_all(type));
  for (Json& type : types) add_old_names(type);
  return {{"engine", engine_version},
          {"types", std::move(types)},
          {"families", family_titles()},
          {"formats", std::move(written)},
          {"nodes", std::move(nodes)}};
}

// Of what may be kept in memory, one part in so many is for the topologies of tiles, beside it.
constexpr std::size_t topology_share = 16;

/// Each engine is given its own kind of requests only.
const PreparedGraph& own(const Prepared& prepared) { return static_cast<const PreparedGraph&>(prepared); }

/// The one file of an export that has run.
Result<SharedFile> exported_file(const PreparedGraph& prepared, const Evaluation& evaluation) {
  const Value value = evaluation.value(prepared.plan, *prepared.export_node, 0);
  if (value.column.index() != static_cast<std::size_t>(WireType::asset) || sample_count(value.axes) != 1) {
    return Problem{"axis-mismatch", "the output must be one file, it has axes", prepared.output};
  }
  return column_of<SharedFile>(value)[0];
}

const Result<Document>& document_in(const InspectRequest& request) {
  return static_cast<const DocumentGraph&>(*request.graph).document;
}

/// The same request of what stands at the outputs of an instance of a group, if it asks for one.
InspectRequest behind_instances(InspectRequest request) {
  const Result<Document>& document = document_in(request);
  if (!document || !document->instances.contains(request.node)) return request;
  const std::string asked = request.node + (request.output.empty() ? "" : "." + request.output);
  PlaceName place = place_name(places_behind(*document, asked).front());
  request.node = std::move(place.node);
  request.output = std::move(place.output);
  return request;
}

/// The nodes of the previews that have something to draw.
std::vector<std::size_t> drawn_nodes(const PreparedGraph& prepared) {
  std::vector<std::size_t> nodes;
  for (const Preview& preview : prepared.previews) {
    if (!preview.outputs.empty()) nodes.push_back(preview.node);
  }
  return nodes;
}

}  // namespace

CatalogueEngine::CatalogueEngine(const Limits& limits, std::vector<FileFormat> formats)
    : limits_(limits),
      formats_(std::move(formats)),
      cache_(limits.cache_bytes),
      topologies_(limits.cache_bytes / topology_share),
      assets_(limits_) {
  add_all_nodes(registry_);
  catalogue_ = catalogue_of(registry_, formats_);
}

Result<AssetSummary> CatalogueEngine::add_asset(std::string_view bytes, const std::string& name,
                                                const Cancel& cancel) const {
  if (!name.empty() && !AssetStore::is_name(name)) {
    return Problem{"usage", "the name of a file has 1 to 64 letters, digits, '_', '-' and '.', and is no hash"};
  }
  const Result<SharedAssetFile> added = assets_.add(bytes, name, cancel);
  if (!added) return added.problems();
  const AssetFile& file = **added;
  return AssetSummary{.sha256 = to_hex(file.sha256),
                      .bytes = file.bytes,
                      .format = std::string(name_of(file.content.format)),
                      .vertices = file.content.mesh.positions.size(),
                      .triangles = file.content.mesh.triangles.size(),
                      .warnings = file.content.warnings};
}

SharedGraph CatalogueEngine::read(const Json& document) const {
  const Digest hash = graph_hash(document);
  // Of what is in no hash, this can be wrong.
  const auto schema = document.find("$schema");
  const bool is_well = schema == document.end() || schema->is_string();
  const Digest key = DigestBuilder().text("graph").digest(hash).finish();
  if (auto known = is_well ? cache_.find<DocumentGraph>(key) : nullptr) return known;
  auto graph = std::make_shared<const DocumentGraph>(document, hash, limits_, registry_);
  if (graph->document) cache_.insert<DocumentGraph>(key, graph, graph->held);
  return graph;
}

Result<Json> CatalogueEngine::interface(const Graph& graph) const {
  const Result<Document>& document = static_cast<const DocumentGraph&>(graph).document;
  if (!document) return document.problems();
  return interface_of(registry_, *document);
}

Result<Json> CatalogueEngine::validate(const Graph& graph, const Json& parameters, const Cancel& cancel,
                                       Sent sent) const {
  const Result<Document>& document = static_cast<const DocumentGraph&>(graph).document;
  ProblemCollector problems;
  CheckReport report;
  if (!document) {
    problems.add(document.problems());
  } else {
    ParameterValues values = usual_parameters(*document);
    if (Result<ParameterValues> given = resolve_parameters(*document, parameters); given) {
      values = std::move(*given);
    } else {
      problems.add(std::move(given).problems());
    }
    report = check(registry_, *document, values, Quality::final, limits_, asset_finder(cancel), {.cancel = &cancel});
    problems.add(report.problems);
  }
  if (cancel.stopped()) return stopped_problem(cancel.reason());
  return validation_report(report, std::move(problems).take(), sent);
}

Result<SharedPrepared> CatalogueEngine::prepare(const EvaluateRequest& request, const Cancel& cancel) const {
  Result<std::shared_ptr<const PreparedGraph>> prepared = prepare_evaluation(environment(cancel), request, cancel);
  if (!prepared) return std::move(prepared).problems();
  return SharedPrepared(*std::move(prepared));
}

std::vector<std::string> CatalogueEngine::blocked(const EvaluateRequest& request, const Cancel& cancel) const {
  return blocked_nodes(environment(cancel), request, cancel);
}

std::vector<std::size_t> CatalogueEngine::wanted_nodes(const PreparedGraph& prepared) const {
  std::vector<std::size_t> wanted = prepared.targets;
  if (!prepared.part_nodes.empty() && !cache_.contains(prepared.parts_digest)) {
    wanted.insert(wanted.end(), prepared.part_nodes.begin(), prepared.part_nodes.end());
  }
  if (prepared.previews.empty() || cache_.contains(prepared.preview_digest)) return wanted;
  const std::vector<std::size_t> drawn = drawn_nodes(prepared);
  wanted.insert(wanted.end(), drawn.begin(), drawn.end());
  return wanted;
}

Json CatalogueEngine::explain(const Prepared& asked) const {
  const PreparedGraph& prepared = own(asked);
  return explanation(prepared, wanted_nodes(prepared), cache_, history_);
}

SharedComputed CatalogueEngine::find(const Prepared& asked) const {
  const PreparedGraph& prepared = own(asked);
  auto found = std::make_shared<ComputedGraph>();
  found->milliseconds["evaluate"] = 0;
  if (!prepared.previews.empty()) {
    found->milliseconds["preview"] = 0;
    found->preview = cache_.find<File>(prepared.preview_digest);
    if (found->preview == nullptr) return nullptr;
  }
  if (!prepared.part_nodes.empty()) {
    found->milliseconds["parts"] = 0;
    found->parts = cache_.find<ToldParts>(prepared.parts_digest);
    if (found->parts == nullptr) return nullptr;
  }
  // The checks beside the output must have held too.
  std::optional<Evaluation> evaluation = find_evaluation(prepared.plan, prepared.targets, cache_);
  if (!evaluation) return nullptr;
  found->evaluation = *std::move(evaluation);
  if (prepared.export_node) {
    found->milliseconds["encode"] = 0;
    Result<SharedFile> model = exported_file(prepared, found->evaluation);
    if (!model) return nullptr;
    found->model = *std::move(model);
  }
  return found;
}

Result<SharedFile> CatalogueEngine::preview_file(const PreparedGraph& prepared, const Evaluation& evaluation,
                                                 const Cancel& cancel) const {
  if (SharedFile known = cache_.find<File>(prepared.preview_digest)) return known;
  const Json about = {{"engine", engine_version}, {"preview", to_hex(prepared.preview_digest)}};
  const EncodeOptions options = {.extras = about, .topologies = &topologies_};
  Result<std::string> drawn = draw_previews(prepared.plan, evaluation, prepared.previews, options, limits_, cancel);
  if (!drawn) return drawn.problems();
  const Digest digest = sha256(*drawn);
  const auto made = std::make_shared<const File>(File{"model/gltf-binary", ".glb", share(*std::move(drawn)), digest});
  cache_.insert<File>(prepared.preview_digest, made, sizeof(File) + made->bytes->size());
  return made;
}

Result<std::shared_ptr<const ToldParts>> CatalogueEngine::told_parts(const PreparedGraph& prepared,
                                                                     const Evaluation& evaluation,
                                                                     const Cancel& cancel) const {
  if (auto known = cache_.find<ToldParts>(prepared.parts_digest)) return known;
  constexpr std::size_t bytes_of_part = 2048;
  auto told =
      std::make_shared<const ToldParts>(ToldParts{parts_of(prepared.plan, *prepared.export_node, evaluation, cancel)});
  if (cancel.stopped()) return stopped_problem(cancel.reason());
  cache_.insert<ToldParts>(prepared.parts_digest, told, bytes_of_part * (1 + told->list.size()));
  return told;
}

Result<SharedComputed> CatalogueEngine::compute(const Prepared& asked, const Job& job) const {
  const PreparedGraph& prepared = own(asked);
  const auto begin = std::chrono::steady_clock::now();
  Result<Evaluation> evaluation = dini::evaluate(prepared.plan, wanted_nodes(prepared), cache_, job);
  if (!evaluation) return placed(evaluation.problems(), *prepared.graph->document);
  history_.note(prepared.graph->hash, prepared.plan, *evaluation);
  auto computed = std::make_shared<ComputedGraph>();
  computed->milliseconds["evaluate"] = milliseconds_since(begin);
  if (prepared.export_node) {
    Result<SharedFile> model = exported_file(prepared, *evaluation);
    if (!model) return model.problems();
    computed->model = *std::move(model);
    const NodeRun* run = evaluation->run(prepared.plan.nodes[*prepared.export_node]);
    computed->milliseconds["encode"] = run != nullptr ? run->milliseconds : 0;
  }
  if (!prepared.part_nodes.empty()) {
    const auto measuring = std::chrono::steady_clock::now();
    auto told = told_parts(prepared, *evaluation, job.cancel);
    if (!told) return told.problems();
    computed->parts = *std::move(told);
    computed->milliseconds["parts"] = milliseconds_since(measuring);
  }
  if (!prepared.previews.empty()) {
    const auto drawing = std::chrono::steady_clock::now();
    Result<SharedFile> drawn = preview_file(prepared, *evaluation, job.cancel);
    if (!drawn) return drawn.problems();
    computed->preview = *std::move(drawn);
    computed->milliseconds["preview"] = milliseconds_since(drawing);
  }
  computed->evaluation = *std::move(evaluation);
  return SharedComputed(std::move(computed));
}

bool CatalogueEngine::is_shareable(const Prepared& asked) const {
  const PreparedGraph& prepared = own(asked);
  return prepared.export_node && prepared.previews.empty() && prepared.part_nodes.empty() &&
         prepared.targets == std::vector{*prepared.export_node};
}

std::string CatalogueEngine::kept_form(const Prepared& asked, const Computed& computed) const {
  const PreparedGraph& prepared = own(asked);
  const auto& evaluation = static_cast<const ComputedGraph&>(computed).evaluation;
  return shared_form(*evaluation.run(prepared.plan.nodes[*prepared.export_node])->result);
}

SharedComputed CatalogueEngine::restore(const Prepared& asked, std::string_view kept) const {
  const PreparedGraph& prepared = own(asked);
  std::optional<NodeResult> read = read_shared_form(kept);
  if (!read) return nullptr;
  const auto result = std::make_shared<const NodeResult>(*std::move(read));
  const std::size_t size = bytes(*result);
  cache_.insert<NodeResult>(prepared.plan.nodes[*prepared.export_node].fingerprint, result, size);
  return find(prepared);
}

Json CatalogueEngine::report(const Prepared& prepared, const Computed& computed, Sent sent, Extent extent) const {
  return evaluation_report(own(prepared), static_cast<const ComputedGraph&>(computed), sent, extent);
}

Result<SharedBytes> CatalogueEngine::inspect(const InspectRequest& asked, const Job& job) const {
  const InspectRequest request = behind_instances(asked);
  const Result<Plan> plan = prepare_inspection(environment(job.cancel), request, job.cancel);
  if (!plan) return plan.problems();
  const std::size_t index = plan->index.at(request.node);
  const PlannedNode& node = plan->nodes[index];
  std::size_t output = 0;
  if (!request.output.empty()) {
    const OutputPort* port = node.type->find_output(request.output);
    if (port == nullptr) return unknown_output(*node.type, request.node, request.output, "/output");
    output = node.type->output_index(request.output);
  }
  if (output >= node.outputs.size()) return bypassed_output(request.node, request.output, "/output");
  const std::size_t count = sample_count(node.outputs[output].axes);
  if (count > inspected_values) {
    return Problem{.code = "limit-exceeded",
                   .detail = "there are " + std::to_string(count) + " values, at most " +
                             std::to_string(inspected_values) + " are shown",
                   .node = request.node,
                   .port = request.output,
                   .pointer = "/output",
                   .in_request = true};
  }
  const Result<Evaluation> evaluation = dini::evaluate(*plan, {index}, cache_, job);
  if (!evaluation) return placed(evaluation.problems(), *document_in(request));
  std::string text = to_json_text(evaluation->value(*plan, index, output), request.full, job.cancel);
  if (job.cancel.stopped()) return stopped_problem(job.cancel.reason());
  return share(std::move(text));
}

std::span<const FileFormat> usual_formats() { return all_formats(); }

std::unique_ptr<Engine> make_engine(const Limits& limits) {
  return make_engine(limits, {all_formats().begin(), all_formats().end()});
}

std::unique_ptr<Engine> make_engine(const Limits& limits, std::vector<FileFormat> formats) {
  return std::make_unique<CatalogueEngine>(limits, std::move(formats));
}

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace dini
