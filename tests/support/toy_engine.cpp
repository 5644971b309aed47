#include "tests/support/toy_engine.h"

#include <chrono>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "graph/stopped.h"

namespace dini::toy {

namespace {

class ToyGraph final : public Graph {
 public:
  explicit ToyGraph(const Json& json) : document(json) { hash = graph_hash(json); }

  const Json document;
};

const Json& document_of(const Graph& graph) { return static_cast<const ToyGraph&>(graph).document; }

class ToyPrepared final : public Prepared {
 public:
  Json inputs;
  Json nodes;
  std::vector<std::string> preview;
  const FileFormat* format = nullptr;
  bool is_fatal = false;
};

Json inputs_of(const Json& graph) {
  const Json out = graph.value("nodes", Json::object()).value("out", Json::object());
  return out.value("inputs", Json::object());
}

Problem problem_of(const std::string& code, const char* node = "out") {
  return {.code = code,
          .detail = "The toy was asked for '" + code + "'.",
          .node = node,
          .port = "amount",
          .pointer = "/nodes/out/inputs/amount"};
}

Problems check(const Json& graph, const Json& parameters) {
  Problems problems;
  const Json inputs = inputs_of(graph);
  if (!graph.contains("nodes")) problems.push_back(problem_of("required-input-missing"));
  if (inputs.contains("invalid")) problems.push_back(problem_of(inputs.at("invalid").get<std::string>()));
  const Json known = graph.value("parameters", Json::object());
  for (const auto& [name, value] : parameters.items()) {
    if (known.contains(name)) continue;
    problems.push_back({.code = "unknown-parameter",
                        .detail = "There is no parameter '" + name + "'.",
                        .pointer = "/parameters/" + name,
                        .in_request = true});
  }
  return problems;
}

/// False when it was stopped before the time was over.
bool spend(const Json& inputs, const Cancel& cancel) {
  const auto until = Cancel::Clock::now() + std::chrono::milliseconds(inputs.value("milliseconds", 0));
  while (Cancel::Clock::now() < until) {
    if (cancel.stopped()) {
      counters().canceled++;
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

Json toy_catalogue() {
  return {{"engine", "0.0.0-toy"},
          {"types", Json::array({{{"name", "integer"}, {"literal_only", true}}, {{"name", "asset"}}})},
          {"families", Json::array({{{"name", "toys"}, {"title", "Toys"}}})},
          {"nodes",
           Json::array(
               {{{"id", "toy"},
                 {"title", "Toy"},
                 {"family", "toys"},
                 {"description", "Waits for a while."},
                 {"inputs", Json::array({{{"name", "milliseconds"}, {"types", {"integer"}}, {"default", 0}}})},
                 {"outputs", Json::array({{{"name", "asset"}, {"types", {"asset"}}, {"description", "Bytes."}}})}}})}};
}

std::vector<FileFormat> toy_formats() {
  return {{"glb", {"model/gltf-binary"}, ".glb", "Many letters.", nullptr},
          {"toy", {"model/x-toy"}, ".toy", "A word and many letters.", nullptr}};
}

SharedFile file_of(bool asked, const FileFormat& format, std::size_t size, char letter) {
  if (!asked) return nullptr;
  std::string bytes = (format.name == "toy" ? "toy" : "") + std::string(size, letter);
  const Digest digest = sha256(bytes);
  return std::make_shared<const File>(
      File{format.media_types.front(), format.extension, share(std::move(bytes)), digest});
}

}  // namespace

Counters& counters() {
  static Counters counters;
  return counters;
}

ToyEngine::ToyEngine(const Limits& limits) : limits_(limits), formats_(toy_formats()), catalogue_(toy_catalogue()) {}

Result<AssetSummary> ToyEngine::add_asset(std::string_view bytes, const std::string& name, const Cancel&) const {
  if (name == "wrong name") return Problem{.code = "usage", .detail = "The toy does not like this name."};
  if (bytes.starts_with("broken"))
    return Problem{.code = "invalid-asset", .detail = "The toy was given a broken file."};
  if (bytes.starts_with("large")) return Problem{.code = "limit-exceeded", .detail = "The toy was given a large file."};
  return AssetSummary{std::string(64, 'a'), bytes.size(), "obj", 3, 1, {"1 line (l) is left out"}};
}

SharedGraph ToyEngine::read(const Json& document) const { return std::make_shared<const ToyGraph>(document); }

Result<Json> ToyEngine::interface(const Graph& graph) const {
  Json properties = Json::object();
  const Json parameters = document_of(graph).value("parameters", Json::object());
  for (const auto& [name, parameter] : parameters.items()) {
    properties[name] = {{"type", "number"}};
  }
  return Json{{"parameters", {{"properties", std::move(properties)}}}, {"outputs", {"out"}}};
}

Result<Json> ToyEngine::validate(const Graph& graph, const Json& parameters, const Cancel&, Sent sent) const {
  const Problems problems = check(document_of(graph), parameters);
  return Json{{"valid", problems.empty()},
              {"errors", to_json(problems, sent)},
              {"wires", Json::object()},
              {"cost", {{"bytes", 8}}}};
}

Result<SharedPrepared> ToyEngine::prepare(const EvaluateRequest& request, const Cancel&) const {
  const Json& document = document_of(*request.graph);
  Problems problems = check(document, request.parameters);
  if (!problems.empty()) return problems;
  auto prepared = std::make_shared<ToyPrepared>();
  prepared->inputs = inputs_of(document);
  prepared->nodes = document["nodes"];
  prepared->is_fatal = request.parameters.value("fatal", Json()) == 1;
  prepared->preview = request.preview;
  prepared->output = request.output.empty() && request.preview.empty() ? "out" : request.output;
  prepared->format = request.format.empty() ? &formats_.front() : format_named(formats_, request.format);
  if (prepared->format == nullptr) return Problem{.code = "not-in-choices", .pointer = "/format", .in_request = true};
  Json content = prepared->inputs;
  content.erase("milliseconds");
  DigestBuilder digest;
  digest.text(content.dump()).text(request.parameters.dump()).text(prepared->output).text(Json(request.preview).dump());
  digest.text(prepared->format->name);
  prepared->content = digest.integer(static_cast<std::uint64_t>(request.triangle_budget.value_or(0))).finish();
  const Digest report = digest.text(prepared->nodes.dump()).finish();
  prepared->model_tag = "\"toy-" + to_hex(prepared->content) + "\"";
  prepared->report_tag = "\"toy-" + to_hex(report) + "\"";
  prepared->bytes = 1;
  ++counters().prepared;
  return SharedPrepared(std::move(prepared));
}

std::vector<std::string> ToyEngine::blocked(const EvaluateRequest&, const Cancel&) const { return {"skin"}; }

Json ToyEngine::explain(const Prepared& prepared) const {
  const int known = find(prepared) != nullptr ? 1 : 0;
  return {{"runs", 1 - known}, {"known", known}, {"work", 0},
          {"milliseconds", 0}, {"bytes", 0},     {"nodes", Json::object()}};
}

SharedComputed ToyEngine::find(const Prepared& prepared) const {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(prepared.content);
  return found == known_.end() ? nullptr : found->second;
}

Result<SharedComputed> ToyEngine::compute(const Prepared& asked, const Job& job) const {
  const auto& prepared = static_cast<const ToyPrepared&>(asked);
  counters().started++;
  struct Finish {
    ~Finish() { counters().finished++; }
  } const finish;
  if (prepared.is_fatal) std::abort();
  if (!spend(prepared.inputs, job.cancel)) return stopped_problem(job.cancel.reason());
  if (prepared.inputs.value("throws", false)) throw std::runtime_error("a secret of the inside");
  if (prepared.inputs.value("memory", false)) throw std::bad_alloc();
  if (prepared.inputs.contains("problem")) return problem_of(prepared.inputs.at("problem").get<std::string>());
  const std::size_t size = prepared.inputs.value("bytes", std::size_t{8});
  auto computed = std::make_shared<Computed>();
  computed->model = file_of(!prepared.output.empty(), *prepared.format, size, 'g');
  computed->preview = file_of(!prepared.preview.empty(), formats_.front(), size, 'p');
  computed->milliseconds = {{"evaluate", 1.5}, {"encode", 0.5}};
  const std::lock_guard lock(mutex_);
  known_[prepared.content] = computed;
  return SharedComputed(std::move(computed));
}

Json ToyEngine::report(const Prepared& asked, const Computed& computed, Sent, Extent extent) const {
  const auto& prepared = static_cast<const ToyPrepared&>(asked);
  Json nodes = Json::object();
  for (const auto& [id, node] : prepared.nodes.items()) nodes[id] = {{"type", "toy"}};
  if (extent == Extent::outcome) return {{"output", prepared.output}, {"checks", Json::array()}};
  return {{"etag", prepared.model_tag},
          {"output", prepared.output},
          {"nodes", std::move(nodes)},
          {"milliseconds", computed.milliseconds},
          {"model", {{"bytes", prepared.inputs.value("bytes", std::size_t{8})}}},
          {"checks", Json::array()},
          {"warnings", Json::array()}};
}

void ToyEngine::forget() const {
  const std::lock_guard lock(mutex_);
  known_.clear();
}

Result<SharedBytes> ToyEngine::inspect(const InspectRequest& request, const Job& job) const {
  if (request.node != "out") return problem_of("unknown-node", request.node.c_str());
  if (!spend(inputs_of(document_of(*request.graph)), job.cancel)) {
    return stopped_problem(job.cancel.reason());
  };
  return share(R"({"type":"number","axes":[],"values":[1]})");
}

}  // namespace dini::toy
