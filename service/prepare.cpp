#include "service/prepare.h"

#include <algorithm>

#include "graph/check.h"
#include "graph/fixes.h"
#include "graph/groups.h"
#include "graph/nearest.h"
#include "graph/parameters.h"
#include "graph/request_problem.h"
#include "graph/stopped.h"
#include "service/measures.h"
#include "service/outputs.h"
#include "service/parts.h"
#include "service/places.h"
#include "service/preview.h"
#include "service/report.h"
#include "service/version.h"

namespace dini {

namespace {

constexpr std::int64_t least_budget = EvaluateRequest::least_triangle_budget;
constexpr std::int64_t largest_budget = EvaluateRequest::most_triangle_budget;

/// A graph with the values of its parameters.
struct GivenGraph {
  std::shared_ptr<const DocumentGraph> graph;
  const Document& document;
  ParameterValues values;
};

Result<GivenGraph> with_parameters(const SharedGraph& graph, const Json& parameters) {
  auto own = std::static_pointer_cast<const DocumentGraph>(graph);  // each engine is given its own kind only
  const Result<Document>& document = own->document;
  if (!document) return document.problems();
  Result<ParameterValues> values = resolve_parameters(*document, parameters);
  if (!values) return values.problems();
  return GivenGraph{std::move(own), *document, *std::move(values)};
}

Result<Detail> detail_of(const EvaluateRequest& request) {
  if (!request.triangle_budget) return Detail(request.quality);
  const std::string pointer = "/triangle_budget";
  const Problem refused{.code = "out-of-range", .pointer = pointer, .in_request = true};
  if (request.quality != Quality::draft) {
    Problem problem = refused;
    problem.detail = "a triangle_budget goes with quality draft only; a final answer is never thinned";
    problem.fix = {{{"op", "remove"}, {"path", pointer}}};
    return problem;
  }
  const std::int64_t budget = std::clamp(*request.triangle_budget, least_budget, largest_budget);
  if (budget != *request.triangle_budget) {
    Problem problem = refused;
    problem.detail = "got " + std::to_string(*request.triangle_budget) + ", accepted is " +
                     std::to_string(least_budget) + " to " + std::to_string(largest_budget);
    problem.fix = {{{"op", "replace"}, {"path", pointer}, {"value", budget}}};
    return problem;
  }
  return Detail(request.quality, static_cast<std::size_t>(budget));
}

std::string reason_of(const Problems& problems, const std::string& node) {
  const auto own =
      std::find_if(problems.begin(), problems.end(), [&](const Problem& problem) { return problem.node == node; });
  return own == problems.end() ? "it stands behind a node that has a problem" : own->detail;
}

/// The checks that cannot run. A check that did not run has not passed, so they fail the request.
Problems broken_checks(const Registry& registry, const Document& document, const CheckReport& report) {
  ProblemCollector broken;
  for (const auto& [id, node] : document.nodes) {
    const NodeType* type = registry.find(node.type);
    if (type == nullptr || !type->always_evaluated || node.bypass) continue;
    const auto planned = report.plan.index.find(id);
    if (planned != report.plan.index.end() && !report.plan.nodes[planned->second].doubtful) continue;
    broken.add([&, &check = id] {
      return Problem{"check-failed", "the check cannot run: " + reason_of(report.elsewhere, check), check, "",
                     input_pointer(check, "")};
    });
  }
  return std::move(broken).take();
}

/// The format asked for; files of previews have one only.
Result<const FileFormat*> format_of(const Environment& environment, const EvaluateRequest& request) {
  const FileFormat* format =
      request.format.empty() ? &environment.formats.front() : format_named(environment.formats, request.format);
  std::vector<std::string> names;
  for (const FileFormat& known : environment.formats) names.push_back(known.name);
  const auto refused = [](std::string detail) {
    return Problem{.code = "not-in-choices", .detail = std::move(detail), .pointer = "/format", .in_request = true};
  };
  if (format == nullptr) {
    return refused("there is no format \"" + request.format + "\"" + did_you_mean(request.format, names));
  }
  if (format != &environment.formats.front() && !request.preview.empty() && request.output.empty()) {
    return refused("previews are written as " + names.front() + " only");
  }
  return format;
}

/// What a file says about itself: the engine, the hash of what the model depends on, the parameters that shape it, and
/// the document where that is asked for.
Json about_file(const PreparedGraph& prepared, const EvaluateRequest& request) {
  Json parameters = Json::object();
  for (const std::string& parameter : parameters_behind(prepared.plan, *prepared.export_node)) {
    parameters[parameter] = prepared.plan.parameters.at(parameter).written;
  }
  Json about = {
      {"engine", engine_version}, {"fingerprint", to_hex(prepared.fingerprint)}, {"parameters", std::move(parameters)}};
  if (prepared.graph->unit) about["unit"] = name(*prepared.graph->unit);
  if (request.embed_graph) {
    about["document"] =
        write_document(prepared.graph->with_groups ? *prepared.graph->with_groups : *prepared.graph->document);
    about["document"].update(request.notes);
  }
  return about;
}

Problem parts_without_output() {
  Problem problem = request_problem("/parts", "unknown-output",
                                    "parts are those of a model, and no output is asked for; name one as `output`");
  problem.fix = {{{"op", "remove"}, {"path", "/parts"}}};
  return problem;
}

/// Memory for a file that needs more than a compressed GLB, whose memory is in the cost of the plan.
std::size_t more_memory(const PlannedNode& exported, const FileFormat& format, bool draco) {
  constexpr std::size_t uncompressed_bytes = 160;  // two copies of the file, less what Draco needs
  std::size_t vertices = 0;
  for (const PlannedInput& input : exported.inputs) {
    for (const PlannedItem& item : input.items) vertices += item.shape.vertices;
  }
  return vertices * (format.vertex_bytes + (draco ? 0 : uncompressed_bytes));
}

/// Tells the node that exports what file is wanted, which its result depends on from then on.
void want_file(PreparedGraph& prepared, const FileFormat& format, const EvaluateRequest& request,
               TopologyCache& topologies) {
  PlannedNode& node = prepared.plan.nodes[*prepared.export_node];
  prepared.fingerprint = node.fingerprint;
  const auto wanted = std::make_shared<const WantedFile>(
      WantedFile{&format, about_file(prepared, request), request.draco, &topologies});
  const std::string about = wanted->about.dump();
  DigestBuilder digest;
  digest.text("file").digest(node.fingerprint).text(format.name).text(about).integer(request.draco ? 1 : 0);
  node.fingerprint = digest.finish();
  node.file = wanted;
  prepared.held += 2 * about.size();
}

/// What the files of an answer depend on, and whether there are any: the checks that must hold count too.
Digest content_digest(const PreparedGraph& prepared) {
  DigestBuilder digest;
  digest.text("content").text(engine_version).digest(prepared.preview_digest);
  for (const std::size_t target : prepared.targets) {
    digest.digest(prepared.plan.nodes[standing_at(prepared.plan, target)].fingerprint);
  }
  if (!prepared.part_nodes.empty()) digest.text("parts").digest(prepared.parts_digest);
  return digest.finish();
}

/// Everything that a report tells besides times: the content, and the graph with its names, types and other problems.
Digest report_digest(const PreparedGraph& prepared) {
  DigestBuilder digest;
  digest.text("report").digest(prepared.content).digest(prepared.graph->hash).text(prepared.output);
  for (const auto& [name, value] : prepared.plan.parameters) digest.text(name).text(value.written.dump());
  for (const Preview& preview : prepared.previews) digest.text(prepared.plan.nodes[preview.node].id);
  for (const Measure& measure : prepared.measures) digest.text(measure.place);
  digest.text(prepared.plan.detail.quality == Quality::draft ? "draft" : "final");
  digest.text(to_json(prepared.elsewhere).dump());
  return digest.finish();
}

std::string tag_of(const Digest& digest) { return "\"" + to_hex(digest) + "\""; }

/// About how much memory a plan holds, its graph included.
std::size_t memory_of(const PreparedGraph& prepared) {
  constexpr std::size_t per_node = 4096, per_item = 1024, per_parameter = 1024;
  std::size_t total = per_parameter * prepared.plan.parameters.size();
  for (const PlannedNode& node : prepared.plan.nodes) {
    total += per_node;
    for (const PlannedInput& input : node.inputs) total += per_item * (1 + input.items.size());
  }
  for (const auto& [name, value] : prepared.plan.parameters) total += 2 * value.written.dump().size();
  return total + prepared.graph->held;
}

/// A request with everything that the check says about it; whether that is good is not yet looked at.
struct CheckedRequest {
  GivenGraph given;
  std::string output = {};  ///< empty when there is none
  PreviewNames previews = {};
  std::vector<MeasureName> measures = {};
  CheckReport report = {};
  bool guarded = false;  ///< the checks of the graph count
};

Result<CheckedRequest> check_request(const Environment& environment, const EvaluateRequest& request,
                                     const Cancel& cancel) {
  const Result<Detail> detail = detail_of(request);
  if (!detail) return detail.problems();
  Result<GivenGraph> given = with_parameters(request.graph, request.parameters);
  if (!given) return given.problems();
  CheckedRequest checked{.given = *std::move(given)};
  const Document& document = checked.given.document;
  CheckScope scope{.cancel = &cancel};
  const bool wants_output = !request.without_output && (request.preview.empty() || !request.output.empty());
  checked.guarded = wants_output || request.without_output;
  scope.guards = checked.guarded;
  if (wants_output) {
    Result<std::string> output = find_output(environment.registry, document, request.output);
    if (!output) return output.problems();
    checked.output = *std::move(output);
    scope.targets.push_back(checked.output);
  }
  Result<PreviewNames> names = read_previews(environment.registry, document, request.preview, environment.limits);
  if (!names) return names.problems();
  checked.previews = *std::move(names);
  for (const auto& [node, outputs] : checked.previews) scope.targets.push_back(node);
  Result<std::vector<MeasureName>> measures =
      read_measures(environment.registry, document, request.measures, environment.limits);
  if (!measures) return measures.problems();
  checked.measures = *std::move(measures);
  for (const MeasureName& measure : checked.measures) scope.targets.push_back(measure.node);
  checked.report = check(environment.registry, document, checked.given.values, *detail, environment.limits,
                         environment.find_asset, scope);
  if (cancel.stopped()) return stopped_problem(cancel.reason());
  return checked;
}

}  // namespace

std::vector<std::string> blocked_nodes(const Environment& environment, const EvaluateRequest& request,
                                       const Cancel& cancel) {
  const Result<CheckedRequest> checked = check_request(environment, request, cancel);
  return checked ? checked->report.blocked : std::vector<std::string>{};
}

Result<std::shared_ptr<const PreparedGraph>> prepare_evaluation(const Environment& environment,
                                                                const EvaluateRequest& request, const Cancel& cancel) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<const FileFormat*> format = format_of(environment, request);
  if (!format) return format.problems();
  Result<CheckedRequest> checked = check_request(environment, request, cancel);
  if (!checked) return checked.problems();
  CheckReport& report = checked->report;
  if (!report.problems.empty()) return report.problems;
  auto prepared = std::make_shared<PreparedGraph>();
  if (!checked->output.empty()) {
    prepared->output = checked->output;
    prepared->export_node = report.plan.index.at(checked->output);
    prepared->targets.push_back(*prepared->export_node);
  }
  if (checked->guarded) {
    Problems broken = broken_checks(environment.registry, checked->given.document, report);
    if (!broken.empty()) return placed(std::move(broken), checked->given.document);
    prepared->targets.insert(prepared->targets.end(), report.guards.begin(), report.guards.end());
  }
  prepared->elsewhere = std::move(report.elsewhere);
  prepared->plan = std::move(report.plan);
  prepared->graph = checked->given.graph;
  Result<std::vector<Preview>> previews = plan_previews(prepared->plan, checked->previews, environment.limits);
  if (!previews) return previews.problems();
  prepared->previews = *std::move(previews);
  Result<std::vector<Measure>> measures = plan_measures(prepared->plan, checked->measures, environment.limits);
  if (!measures) return measures.problems();
  prepared->measures = *std::move(measures);
  for (const Measure& measure : prepared->measures) prepared->targets.push_back(measure.node);
  if (request.parts) {
    if (!prepared->export_node) return parts_without_output();
    Result<std::vector<std::size_t>> nodes = plan_parts(prepared->plan, *prepared->export_node, environment.limits);
    if (!nodes) return nodes.problems();
    prepared->part_nodes = *std::move(nodes);
    prepared->parts_digest = parts_digest(prepared->plan, *prepared->export_node);
  }
  if (prepared->export_node) want_file(*prepared, **format, request, environment.topologies);
  if (!prepared->previews.empty()) {
    prepared->preview_digest = preview_digest(prepared->plan, prepared->previews, environment.limits);
  }
  prepared->content = content_digest(*prepared);
  prepared->model_tag = tag_of(prepared->content);
  prepared->report_tag = tag_of(report_digest(*prepared));
  prepared->bytes = prepared->plan.cost.bytes;
  if (prepared->export_node)
    prepared->bytes += more_memory(prepared->plan.nodes[*prepared->export_node], **format, request.draco);
  prepared->work = prepared->plan.cost.work;
  prepared->held += memory_of(*prepared);
  prepared->milliseconds = milliseconds_since(begin);
  return std::shared_ptr<const PreparedGraph>(std::move(prepared));
}

Result<Plan> prepare_inspection(const Environment& environment, const InspectRequest& request, const Cancel& cancel) {
  const Result<GivenGraph> given = with_parameters(request.graph, request.parameters);
  if (!given) return given.problems();
  if (!given->document.nodes.contains(request.node)) {
    return unknown_node(given->document, {request.node, request.output, !request.output.empty()}, "/node");
  }
  CheckReport report = check(environment.registry, given->document, given->values, Quality::final, environment.limits,
                             environment.find_asset, {{request.node}, false, &cancel});
  if (cancel.stopped()) return stopped_problem(cancel.reason());
  if (!report.problems.empty()) return report.problems;
  return std::move(report.plan);
}

}  // namespace dini
