#include "fitting/model.h"

#include <algorithm>
#include <cmath>

#include "graph/json_reader.h"
#include "graph/request_problem.h"
#include "graph/stopped.h"

namespace dini::fitting {
namespace {

/// The step of a derivative on the scale of places. Values are exact to about 1e-15 of their size, so that half of the
/// digits are for the difference, and the others for what bends within the step.
constexpr double difference_step = 1e-6;

/// All numbers of a number or of lists in lists; nothing for anything else.
bool gather_numbers(const Json& json, std::vector<double>& numbers) {
  if (json.is_number()) {
    numbers.push_back(json.get<double>());
    return true;
  }
  if (!json.is_array()) return false;
  for (const Json& item : json) {
    if (item.is_number()) {
      numbers.push_back(item.get<double>());
    } else if (!item.is_array() || !std::ranges::all_of(item, [](const Json& number) { return number.is_number(); })) {
      return false;
    } else {
      for (const Json& number : item) numbers.push_back(number.get<double>());
    }
  }
  return true;
}

Result<std::vector<NumberGoal>> read_targets(const Json& targets) {
  std::vector<NumberGoal> goals;
  Problems problems;
  for (const auto& [place, wanted] : targets.items()) {
    NumberGoal goal{.place = place, .wanted = {}};
    if (!gather_numbers(wanted, goal.wanted) || goal.wanted.empty()) {
      problems.push_back(request_problem("/targets/" + pointer_token(place), "type-mismatch",
                                         place + " is to be a number, or a list of all numbers of that output"));
      continue;
    }
    double largest = 0;
    for (const double number : goal.wanted) largest = std::max(largest, std::abs(number));
    goal.size = largest > 0 ? largest : 1;
    goals.push_back(std::move(goal));
  }
  if (!problems.empty()) return problems;
  return goals;
}

/// Problems of a member that this request calls otherwise.
Problems at_member(Problems problems, std::string_view from, const std::string& to) {
  for (Problem& problem : problems) {
    if (problem.in_request && problem.pointer == from) problem.pointer = to;
  }
  return problems;
}

Result<std::string> place_of_mesh(const ValueSource& source, const FitRequest& request) {
  if (!request.mesh.empty()) return request.mesh;
  const auto exported = source.exported_places(*request.graph);
  if (!exported) return at_member(exported.problems(), "/output", "/mesh");
  if (exported->size() == 1) return exported->front();
  std::string list;
  for (const std::string& place : *exported) list += (list.empty() ? "" : ", ") + place;
  return request_problem("/mesh", "required-input-missing",
                         exported->empty()
                             ? "nothing is exported, so `mesh` names the output that is to be like the mesh"
                             : "several outputs are exported, so `mesh` names one of " + list);
}

Result<MeshGoal> read_mesh(const ValueSource& source, const std::string& name, const Cancel& cancel) {
  const auto file = source.mesh_file(name, cancel);
  if (!file) {
    Problem problem = file.problems().front();
    problem.pointer = "/target_mesh";
    return problem;
  }
  const auto column = single_column<SharedMesh>(std::make_shared<const Mesh>((*file)->content.mesh));
  Surface target = surface_of(Value{{}, column});
  if (target.triangles.empty()) {
    return request_problem("/target_mesh", "degenerate", "the mesh file has no triangles to be like");
  }
  return MeshGoal(std::move(target), cancel);
}

bool all_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool all_finite(const Surface& surface) {
  return std::ranges::all_of(surface.positions, [](const Vector& position) { return is_finite(position); });
}

std::vector<double> differences(const std::vector<double>& from, const std::vector<double>& to, double step) {
  std::vector<double> slopes(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) slopes[i] = (to[i] - from[i]) / step;
  return slopes;
}

}  // namespace

Result<Model> Model::read(const Engine& engine, const FitRequest& request, const Cancel& cancel) {
  const ValueSource* source = engine.value_source();
  if (source == nullptr) return request_problem("", "internal", "this engine has no values to fit");
  if (request.targets.empty() && request.target_mesh.empty() && request.minimize.empty()) {
    return request_problem("", "required-input-missing", "a fit needs targets, a target_mesh or something to minimize");
  }
  if (!request.mesh.empty() && request.target_mesh.empty()) {
    return request_problem("/mesh", "required-input-missing",
                           "mesh goes with a target_mesh, the file that it is to be like");
  }
  const Result<Json> interface = engine.interface(*request.graph);
  if (!interface) return interface.problems();
  Model model(*source, cancel);
  auto varied = read_varied(request.vary, *interface, request.parameters);
  if (!varied) return varied.problems();
  auto targets = read_targets(request.targets);
  if (!targets) return targets.problems();
  model.varied_ = *std::move(varied);
  model.targets_ = *std::move(targets);
  model.minimized_ = request.minimize;
  model.request_ = {.graph = request.graph, .parameters = request.parameters};
  for (const NumberGoal& goal : model.targets_) model.request_.places.push_back(goal.place);
  for (const std::string& place : request.minimize) model.request_.places.push_back(place);
  if (!request.target_mesh.empty()) {
    const auto place = place_of_mesh(*source, request);
    if (!place) return place.problems();
    auto mesh = read_mesh(*source, request.target_mesh, cancel);
    if (!mesh) return mesh.problems();
    model.mesh_.emplace(*std::move(mesh));
    model.request_.places.push_back(*place);
  }
  return model;
}

Result<Sample> Model::begin() {
  Result<Sample> first = std::move(at({start_of(varied_)}).front());
  if (!first) return at_own_places(first.problems());
  for (std::size_t k = 0; k < minimized_.size(); ++k) {
    const double value = first->numbers[targets_.size() + k].front(), size = std::abs(value) > 0 ? std::abs(value) : 1;
    sizes_.push_back(size);
    first->minimized += value / size;
  }
  return first;
}

Result<std::size_t> memory_of_one(const Engine& engine, const ValuesRequest& request, const Json& setting,
                                  const Cancel& cancel) {
  EvaluateRequest one{
      .graph = request.graph, .parameters = request.parameters, .measures = request.places, .without_output = true};
  one.parameters.update(setting);
  const auto prepared = engine.prepare(one, cancel);
  return prepared ? (*prepared)->bytes : Result<std::size_t>(prepared.problems());
}

Result<std::size_t> Model::memory(const Engine& engine, std::size_t together) const {
  const auto one = memory_of_one(engine, request_, setting_at(varied_, start_of(varied_)), *cancel_);
  if (!one) return at_own_places(one.problems());
  // The family is cut where it would be over the limit. A mesh is looked at by a tree of its own, one after another.
  const std::size_t family = std::max(together, varied_.size() + 1) * *one;
  return std::min(engine.limits().request_bytes, family + (mesh_ ? *one + mesh_->bytes() : 0));
}

Problems Model::at_own_places(Problems problems) const {
  constexpr std::string_view measures = "/measures/";
  for (Problem& problem : problems) {
    if (!problem.in_request || !problem.pointer || !problem.pointer->starts_with(measures)) continue;
    const auto index = static_cast<std::size_t>(std::stoul(problem.pointer->substr(measures.size())));
    problem.pointer = pointer_to(index);
  }
  return at_member(std::move(problems), "/measures", targets_.empty() ? "/minimize" : "/targets");
}

std::string Model::pointer_to(std::size_t place) const {
  if (place < targets_.size()) return "/targets/" + pointer_token(targets_[place].place);
  if (place - targets_.size() < minimized_.size()) return "/minimize/" + std::to_string(place - targets_.size());
  return "/mesh";
}

std::vector<SettingValues> Model::values_at(const std::vector<Place>& places) {
  std::vector<Json> settings;
  for (const Place& place : places) settings.push_back(setting_at(varied_, place));
  evaluations_ += static_cast<std::int64_t>(places.size());
  auto values = source_->values(request_, settings, *cancel_);
  if (values) return *std::move(values);
  return std::vector<SettingValues>(places.size(), SettingValues(values.problems()));
}

Result<Sample> Model::sample_of(const std::vector<Value>& values) const {
  Sample sample;
  const std::size_t numbers = targets_.size() + minimized_.size();
  for (std::size_t k = 0; k < numbers; ++k) {
    const bool is_target = k < targets_.size();
    const std::string& place = is_target ? targets_[k].place : minimized_[k - targets_.size()];
    const std::string pointer = pointer_to(k);
    auto found = numbers_of(values[k]);
    if (!found)
      return request_problem(pointer, "type-mismatch",
                             place + " has no numbers; accepted are numbers, vectors, points");
    const std::size_t wanted = is_target ? targets_[k].wanted.size() : 1;
    if (found->size() != wanted) {
      return request_problem(pointer, "axis-mismatch",
                             place + " has " + std::to_string(found->size()) + " numbers, " + std::to_string(wanted) +
                                 (is_target ? " are given" : " can be minimized"));
    }
    if (!all_finite(*found)) return request_problem(pointer, "non-finite", place + " is not finite");
    if (is_target) {
      for (std::size_t i = 0; i < wanted; ++i) {
        sample.conditions.push_back(((*found)[i] - targets_[k].wanted[i]) / targets_[k].size);
      }
    } else if (k - targets_.size() < sizes_.size()) {
      sample.minimized += found->front() / sizes_[k - targets_.size()];
    }
    sample.numbers.push_back(*std::move(found));
  }
  if (!mesh_) return sample;
  const std::string& place = request_.places.back();
  if (values.back().type() != WireType::mesh) {
    return request_problem("/mesh", "type-mismatch", place + " is no mesh; name an output that is one");
  }
  sample.surface = surface_of(values.back());
  if (sample.surface.triangles.empty()) return request_problem("/mesh", "degenerate", place + " has no triangles");
  if (!all_finite(sample.surface)) {
    return request_problem("/mesh", "non-finite", place + " is not finite");
  }
  sample.feet = mesh_->feet_of(sample.surface, *cancel_);
  sample.distances = mesh_->residuals(sample.feet);
  if (cancel_->stopped()) return stopped_problem(cancel_->reason());
  return sample;
}

std::vector<Result<Sample>> Model::at(const std::vector<Place>& places) {
  std::vector<Result<Sample>> samples;
  for (const SettingValues& values : values_at(places)) {
    samples.push_back(values ? sample_of(*values) : Result<Sample>(values.problems()));
  }
  return samples;
}

Slopes Model::slopes(const Place& place, const Sample& sample) {
  std::vector<Place> stepped;
  std::vector<double> steps;
  for (std::size_t k = 0; k < place.size(); ++k) {
    stepped.push_back(place);
    stepped.back()[k] = place[k] + (place[k] > 0.5 ? -difference_step : difference_step);
    steps.push_back(stepped.back()[k] - place[k]);
  }
  const std::vector<SettingValues> values = values_at(stepped);
  const std::size_t numbers = targets_.size() + minimized_.size();
  Slopes slopes;
  for (std::size_t k = 0; k < place.size(); ++k) {
    double minimized = 0;
    std::vector<double> conditions(sample.conditions.size()), distances(sample.distances.size());
    if (values[k]) {
      std::size_t before = 0;
      for (std::size_t i = 0; i < numbers; ++i) {
        const auto moved = numbers_of((*values[k])[i]);
        const bool is_same = moved && moved->size() == sample.numbers[i].size() && all_finite(*moved);
        const std::vector<double> grown =
            is_same ? differences(sample.numbers[i], *moved, steps[k]) : std::vector<double>(sample.numbers[i].size());
        if (i >= targets_.size()) {
          minimized += grown.front() / sizes_[i - targets_.size()];
        } else {
          for (const double slope : grown) conditions[before++] = slope / targets_[i].size;
        }
      }
      if (mesh_) {
        const Surface moved = surface_of(values[k]->back());
        const bool is_same = moved.positions.size() == sample.surface.positions.size() && all_finite(moved);
        if (is_same) distances = mesh_->slopes(sample.feet, sample.surface, moved, steps[k]);
      }
    }
    slopes.minimized.push_back(minimized);
    slopes.conditions.push_back(std::move(conditions));
    slopes.distances.push_back(std::move(distances));
  }
  return slopes;
}

}  // namespace dini::fitting
