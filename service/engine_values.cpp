// The engine over the catalogue as a source of values: many settings of one graph evaluated as one family.

#include <algorithm>
#include <tbb/parallel_for.h>

#include "graph/evaluate.h"
#include "graph/nearest.h"
#include "graph/stopped.h"
#include "service/catalogue_engine.h"
#include "service/outputs.h"

namespace dini {
namespace {

using SharedPlan = std::shared_ptr<const PreparedGraph>;

void shift(PlannedItem& item, std::size_t nodes) {
  if (auto* source = std::get_if<Source>(&item.from)) source->node += nodes;
}

/// All of these plans as one, in their order. What several of them compute has one fingerprint, so an evaluation
/// computes it once.
Plan joined(std::span<const SharedPlan> family) {
  Plan all;
  all.detail = family.front()->plan.detail;
  for (const SharedPlan& member : family) {
    const std::size_t before = all.nodes.size();
    for (PlannedNode node : member->plan.nodes) {
      for (PlannedInput& input : node.inputs) {
        for (PlannedItem& item : input.items) shift(item, before);
      }
      if (node.bypass) shift(*node.bypass, before);
      all.nodes.push_back(std::move(node));
    }
  }
  return all;
}

std::vector<std::size_t> targets_of(std::span<const SharedPlan> family) {
  std::vector<std::size_t> targets;
  std::size_t before = 0;
  for (const SharedPlan& member : family) {
    for (const std::size_t target : member->targets) targets.push_back(before + target);
    before += member->plan.nodes.size();
  }
  return targets;
}

/// A value for each of the places. One that is wanted twice is measured once.
std::vector<Value> measured(const PreparedGraph& member, const std::vector<std::string>& places,
                            const Evaluation& evaluation) {
  std::vector<Value> values;
  for (const std::string& place : places) {
    const auto measure = std::ranges::find(member.measures, place, &Measure::place);
    values.push_back(evaluation.value(member.plan, measure->node, measure->output));
  }
  return values;
}

/// One setting by itself.
SettingValues values_of(const SharedPlan& member, const std::vector<std::string>& places, Cache& cache,
                        const Cancel& cancel) {
  const Progress unseen;
  const Result<Evaluation> evaluation = evaluate(member->plan, member->targets, cache, cancel, unseen);
  if (!evaluation) return evaluation.problems();
  return measured(*member, places, *evaluation);
}

/// All together. Where one fails they are evaluated one by one: what succeeded is in the cache by then.
std::vector<SettingValues> values_of(std::span<const SharedPlan> family, const std::vector<std::string>& places,
                                     Cache& cache, const Cancel& cancel) {
  const Progress unseen;
  const Result<Evaluation> evaluation = evaluate(joined(family), targets_of(family), cache, cancel, unseen);
  std::vector<SettingValues> values;
  for (const SharedPlan& member : family) {
    if (evaluation) {
      values.emplace_back(measured(*member, places, *evaluation));
    } else if (cancel.stopped()) {
      values.emplace_back(stopped_problem(cancel.reason()));
    } else {
      values.push_back(values_of(member, places, cache, cancel));
    }
  }
  return values;
}

}  // namespace

Result<std::vector<SettingValues>> CatalogueEngine::values(const ValuesRequest& request, std::span<const Json> settings,
                                                           const Cancel& cancel) const {
  std::vector<Result<SharedPlan>> prepared(settings.size(), Result<SharedPlan>(SharedPlan()));
  tbb::parallel_for(std::size_t{0}, settings.size(), [&](std::size_t i) {
    EvaluateRequest each{
        .graph = request.graph, .parameters = request.parameters, .measures = request.places, .without_output = true};
    each.parameters.update(settings[i]);
    prepared[i] = prepare_evaluation(environment(cancel), each, cancel);
  });
  std::vector<SettingValues> answers(settings.size(), SettingValues(std::vector<Value>()));
  std::vector<SharedPlan> family;
  std::vector<std::size_t> places;
  std::size_t bytes = 0;
  const auto evaluate_family = [&] {
    if (family.empty()) return;
    std::vector<SettingValues> values = values_of(family, request.places, cache_, cancel);
    for (std::size_t k = 0; k < places.size(); ++k) answers[places[k]] = std::move(values[k]);
    family.clear();
    places.clear();
    bytes = 0;
  };
  for (std::size_t i = 0; i < settings.size() && !cancel.stopped(); ++i) {
    if (!prepared[i]) {
      answers[i] = std::move(prepared[i]).problems();
      continue;
    }
    if (bytes + (*prepared[i])->bytes > limits_.request_bytes) evaluate_family();
    bytes += (*prepared[i])->bytes;
    family.push_back(*std::move(prepared[i]));
    places.push_back(i);
  }
  evaluate_family();
  if (cancel.stopped()) return stopped_problem(cancel.reason());
  return answers;
}

Result<std::vector<std::string>> CatalogueEngine::exported_places(const Graph& graph) const {
  const Result<Document>& document = static_cast<const DocumentGraph&>(graph).document;
  if (!document) return document.problems();
  const Result<std::string> output = find_output(registry_, *document, "");
  if (!output) return output.problems();
  std::vector<std::string> places;
  const NodeEntry& node = document->nodes.at(*output);
  const auto model = node.inputs.find("model");
  if (model == node.inputs.end()) return places;
  for (const InputItem& item : model->second.items) {
    const auto* link = std::get_if<Link>(&item);
    if (link == nullptr) continue;
    places.push_back(link->output.empty() ? link->node : link->node + "." + link->output);
  }
  return places;
}

Result<SharedAssetFile> CatalogueEngine::mesh_file(const std::string& name, const Cancel& cancel) const {
  if (SharedAssetFile file = assets_.find(name, cancel)) return file;
  if (cancel.stopped()) return stopped_problem(cancel.reason());
  return Problem{.code = "unknown-asset",
                 .detail = "there is no mesh file \"" + name +
                           "\" here; give it with POST /v1/assets and write its "
                           "sha256",
                 .in_request = true};
}

}  // namespace dini
