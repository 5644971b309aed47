#include "tests/support/toy_engine.h"

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "service/engine.h"

namespace dini {

struct Engine::State {
  Limits limits;
  Json catalogue;
};

class Prepared {
 public:
  Json inputs;
  std::string output;
  std::vector<std::string> preview;
  std::string tag;
};

namespace {

Json inputs_of(const Json& graph) {
  const Json out = graph.value("nodes", Json::object()).value("out", Json::object());
  return out.value("inputs", Json::object());
}

Problem problem_of(const std::string& code, const char* node = "out") {
  return {.code = code,
          .detail = "The toy was asked for '" + code + "'.",
          .node = node,
          .port = "amount",
          .pointer = "/graph/nodes/out/inputs/amount"};
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
                        .pointer = "/parameters/" + name});
  }
  return problems;
}

Problem stopped(StopReason reason) {
  toy::counters().canceled++;
  switch (reason) {
    case StopReason::superseded:
      return problem_of("superseded");
    case StopReason::client_gone:
      return problem_of("client-gone");
    case StopReason::shutting_down:
      return problem_of("shutting-down");
    default:
      return problem_of("deadline");
  }
}

}  // namespace

namespace toy {

Counters& counters() {
  static Counters counters;
  return counters;
}

}  // namespace toy

Engine::Engine(Limits limits) : state_(std::make_unique<State>()) {
  state_->limits = limits;
  state_->catalogue = {
      {"engine", "0.0.0-toy"},
      {"types", Json::array({{{"name", "number"}}})},
      {"families", Json::array({{{"name", "toys"}, {"title", "Toys"}}})},
      {"nodes",
       Json::array({{{"id", "toy"},
                     {"title", "Toy"},
                     {"family", "toys"},
                     {"doc", "Waits for a while."},
                     {"inputs", Json::array({{{"name", "milliseconds"}, {"types", {"integer"}}, {"default", 0}}})},
                     {"outputs", Json::array({{{"name", "asset"}, {"types", {"asset"}}, {"doc", "Bytes."}}})}}})}};
}

Engine::~Engine() = default;

const Limits& Engine::limits() const { return state_->limits; }

const Json& Engine::catalogue() const { return state_->catalogue; }

Result<AssetSummary> Engine::add_asset(std::string_view bytes, const std::string& name, const Cancel&) const {
  if (name == "wrong name") return Problem{.code = "usage", .detail = "The toy does not like this name."};
  if (bytes.starts_with("broken"))
    return Problem{.code = "invalid-asset", .detail = "The toy was given a broken file."};
  if (bytes.starts_with("large")) return Problem{.code = "limit-exceeded", .detail = "The toy was given a large file."};
  return AssetSummary{std::string(64, 'a'), bytes.size(), "obj", 3, 1, {"1 line (l) is left out"}};
}

Json Engine::validate(const Json& graph, const Json& parameters) const {
  const Problems problems = check(graph, parameters);
  return {
      {"valid", problems.empty()}, {"errors", to_json(problems)}, {"wires", Json::object()}, {"cost", {{"bytes", 8}}}};
}

Result<std::shared_ptr<const Prepared>> Engine::prepare(const EvaluateRequest& request) const {
  Problems problems = check(request.graph, request.parameters);
  if (!problems.empty()) return problems;
  auto prepared = std::make_shared<Prepared>();
  prepared->inputs = inputs_of(request.graph);
  prepared->preview = request.preview;
  prepared->output = request.output.empty() && request.preview.empty() ? "out" : request.output;
  const std::string key = prepared->inputs.dump() + request.parameters.dump() + prepared->output +
                          Json(prepared->preview).dump() + std::to_string(request.triangle_budget.value_or(0));
  prepared->tag = "\"toy-" + std::to_string(std::hash<std::string>()(key)) + "\"";
  return std::shared_ptr<const Prepared>(prepared);
}

std::vector<std::string> Engine::blocked(const EvaluateRequest&) const { return {"skin"}; }

const std::string& Engine::entity_tag(const Prepared& prepared) { return prepared.tag; }

Result<Evaluated> Engine::evaluate(const Prepared& prepared, const Cancel& cancel) const {
  toy::counters().started++;
  struct Finish {
    ~Finish() { toy::counters().finished++; }
  } const finish;
  const auto until = Cancel::Clock::now() + std::chrono::milliseconds(prepared.inputs.value("milliseconds", 0));
  while (Cancel::Clock::now() < until) {
    if (cancel.stopped()) return stopped(cancel.reason());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (prepared.inputs.value("throws", false)) throw std::runtime_error("a secret of the inside");
  if (prepared.inputs.contains("problem")) return problem_of(prepared.inputs.at("problem").get<std::string>());
  const std::size_t size = prepared.inputs.value("bytes", std::size_t{8});
  const auto file = [size](bool asked, char letter) {
    return asked ? std::make_shared<std::string>(size, letter) : nullptr;
  };
  return Evaluated{.glb = file(!prepared.output.empty(), 'g'),
                   .preview = file(!prepared.preview.empty(), 'p'),
                   .milliseconds = {{"evaluate", 1.5}, {"encode", 0.5}},
                   .report = [tag = prepared.tag, output = prepared.output, size]() -> Json {
                     return {{"etag", tag},
                             {"output", output},
                             {"milliseconds", {{"evaluate", 1.5}, {"encode", 0.5}}},
                             {"model", {{"bytes", size}}},
                             {"checks", Json::array()},
                             {"warnings", Json::array()}};
                   }};
}

Result<Json> Engine::inspect(const InspectRequest& request, const Cancel& cancel) const {
  if (request.node != "out") return problem_of("unknown-node", request.node.c_str());
  const auto until =
      Cancel::Clock::now() + std::chrono::milliseconds(inputs_of(request.graph).value("milliseconds", 0));
  while (Cancel::Clock::now() < until) {
    if (cancel.stopped()) return stopped(cancel.reason());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return Json{{"type", "number"}, {"axes", Json::array()}, {"values", {1}}};
}

Json to_json(const Problems& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems) {
    Json item = {{"code", problem.code}, {"detail", problem.detail}};
    if (!problem.node.empty()) item["node"] = problem.node;
    if (!problem.port.empty()) item["port"] = problem.port;
    if (!problem.pointer.empty()) item["pointer"] = problem.pointer;
    if (!problem.fix.is_null()) item["fix"] = problem.fix;
    list.push_back(std::move(item));
  }
  return list;
}

}  // namespace dini
