#include "fitting/fit.h"

#include <algorithm>

#include "fitting/determination.h"
#include "fitting/search.h"
#include "graph/stopped.h"

namespace dini::fitting {
namespace {

/// A sum of squares of what is missing in proportion that no other start would better to any purpose.
constexpr double met = 1e-13;

/// One number as it is, several in a list.
Json told(const std::vector<double>& numbers) { return numbers.size() == 1 ? Json(numbers.front()) : Json(numbers); }

Json start_json(const Model& model, const Place& start, const std::optional<Found>& found) {
  Json json = {{"from", setting_at(model.varied(), start)}, {"failed", !found}};
  if (found) {
    json["parameters"] = setting_at(model.varied(), found->place);
    json["objective"] = found->merit.objective;
  }
  return json;
}

std::vector<std::string> at_bounds(const Model& model, const Place& place) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] <= 0 || place[k] >= 1) names.push_back(model.varied()[k].name);
  }
  return names;
}

Json best_json(const Model& model, const Search& search) {
  const Found& best = search.best();
  Json json = {{"parameters", setting_at(model.varied(), best.place)},
               {"objective", best.merit.objective},
               {"at_bounds", at_bounds(model, best.place)}};
  Json targets = Json::object(), minimized = Json::object();
  for (std::size_t k = 0; k < model.targets().size(); ++k) {
    const NumberGoal& goal = model.targets()[k];
    targets[goal.place] = {{"wanted", told(goal.wanted)}, {"found", told(best.sample.numbers[k])}};
  }
  for (std::size_t k = 0; k < model.minimized().size(); ++k) {
    minimized[model.minimized()[k]] = best.sample.numbers[model.targets().size() + k].front();
  }
  json["targets"] = std::move(targets);
  json["minimized"] = std::move(minimized);
  if (model.mesh()) {
    const MeshDistance distance = model.mesh()->distance(best.sample.feet);
    json["distance"] = {{"root_mean_square", distance.root_mean_square}, {"largest", distance.largest}};
  }
  return json;
}

/// Of a search that came to its end.
std::string outcome_of(const Search& search) {
  // Found, but not within the conditions: nothing near keeps them.
  return search.has_conditions() && search.best().merit.missing > 1e-6 ? "conditions" : "converged";
}

}  // namespace

Result<std::size_t> check(const Engine& engine, const FitRequest& request, const Cancel& cancel) {
  const Result<Model> model = Model::read(engine, request, cancel);
  if (!model) return model.problems();
  return model->memory(engine, request.starts > 1 ? Search::evaluated_together : 1);
}

Result<Json> fit(const Engine& engine, const FitRequest& request, const Job& job, const FitTerms& terms) {
  Result<Model> read = Model::read(engine, request, job.cancel);
  if (!read) return read.problems();
  Model& model = *read;
  Result<Sample> first = model.begin();
  if (!first) return first.problems();
  Search search(model, request, *std::move(first), job, terms);
  Json starts = Json::array();
  const auto is_met = [&] { return model.minimized().empty() && search.best().merit.objective < met; };
  const auto begin_at = [&](const Place& start) {
    if (search.stopped()) return;
    const std::optional<Found> found = search.descend(start);
    starts.push_back(start_json(model, start, found));
  };
  begin_at(start_of(model.varied()));
  if (!is_met()) {
    for (const Place& start : search.other_starts()) {
      if (!is_met()) begin_at(start);
    }
  }
  const bool was_late = search.ran_out_of_time(), was_short = search.ran_out_of_evaluations();
  if (job.cancel.stopped() && !was_late) return stopped_problem(job.cancel.reason());
  Json answer = best_json(model, search);
  answer["outcome"] = was_late ? "deadline" : was_short ? "evaluations" : outcome_of(search);
  answer["starts"] = std::move(starts);
  Json undetermined = Json::array();
  if (!was_late) {
    for (const Undetermined& each : undetermined_by(search.rise(), model.varied())) {
      undetermined.push_back({{"parameters", each.parameters}, {"detail", each.detail}});
    }
  }
  answer["undetermined"] = std::move(undetermined);
  answer["evaluations"] = model.evaluations();
  return answer;
}

Json with_defaults(Json document, const Json& parameters) {
  for (const auto& [name, value] : parameters.items()) document["parameters"][name]["default"] = value;
  return document;
}

}  // namespace dini::fitting
