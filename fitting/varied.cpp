#include "fitting/varied.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graph/json_reader.h"
#include "graph/nearest.h"
#include "graph/request_problem.h"

namespace dini::fitting {
namespace {

constexpr std::size_t most_varied = 64;

const Json& properties_of(const Json& interface) { return interface.at("parameters").at("properties"); }

std::vector<std::string> numbers_in(const Json& interface) {
  std::vector<std::string> names;
  for (const auto& [name, schema] : properties_of(interface).items()) {
    if (schema.value("type", "") == "number") names.push_back(name);
  }
  return names;
}

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "the graph has no parameter that is a number" : "there is " + list;
}

/// A parameter that is not there, or is no number.
Problems faults_in_name(const std::string& name, const Json& interface, const std::string& pointer) {
  const auto schema = properties_of(interface).find(name);
  const std::vector<std::string> known = numbers_in(interface);
  if (schema == properties_of(interface).end()) {
    return {request_problem(
        pointer, "unknown-parameter",
        "the graph has no parameter \"" + name + "\"" + did_you_mean(name, known) + "; " + list_of(known))};
  }
  if (schema->value("type", "") == "number") return {};
  return {request_problem(pointer, "type-mismatch",
                          name + " is no number, and only numbers change little by little; " + list_of(known))};
}

double value_of(const std::string& name, const Json& schema, const Json& parameters) {
  const auto given = parameters.find(name);
  const Json& value = given != parameters.end() && given->is_number() ? *given : schema.at("default");
  return value.get<double>();
}

/// What is wrong with a value that a varied parameter is given: the engine never sees it, since the search sets others.
std::optional<Problem> fault_in_start(const Varied& varied, const Json& parameters) {
  const auto given = parameters.find(varied.name);
  if (given == parameters.end()) return std::nullopt;
  const std::string pointer = "/parameters/" + pointer_token(varied.name);
  if (!given->is_number()) {
    return request_problem(pointer, "type-mismatch",
                           varied.name + " begins at " + given->dump() + ", which is no number");
  }
  if (varied.start >= varied.lowest && varied.start <= varied.highest) return std::nullopt;
  return request_problem(pointer, "out-of-range",
                         varied.name + " begins at " + given->dump() + "; accepted is what it varies in, " +
                             Json(varied.lowest).dump() + " to " + Json(varied.highest).dump());
}

constexpr double unbounded = std::numeric_limits<double>::infinity();

Varied own_bounds(const std::string& name, const Json& schema, const Json& parameters) {
  return {name, schema.value("minimum", -unbounded), schema.value("maximum", unbounded),
          value_of(name, schema, parameters)};
}

Result<Varied> read_one(const std::string& name, const Json& bounds, const Json& schema, const Json& parameters) {
  const std::string pointer = "/vary/" + pointer_token(name);
  Varied varied = own_bounds(name, schema, parameters);
  const bool are_two = bounds.is_array() && bounds.size() == 2 && bounds[0].is_number() && bounds[1].is_number();
  if (!are_two && !(bounds.is_array() && bounds.empty())) {
    return request_problem(pointer, "type-mismatch",
                           name + " takes [lowest, highest], or [] for the bounds of the parameter");
  }
  if (are_two) {
    const double low = bounds[0].get<double>(), high = bounds[1].get<double>();
    if (low < varied.lowest || high > varied.highest || !(low < high)) {
      return request_problem(pointer, "out-of-range",
                             name + " is to vary from " + bounds[0].dump() + " to " + bounds[1].dump() +
                                 "; accepted is from a lower to a higher number within " +
                                 schema.value("minimum", Json("anything")).dump() + " to " +
                                 schema.value("maximum", Json("anything")).dump());
    }
    varied.lowest = low;
    varied.highest = high;
  } else if (varied.lowest == -unbounded || varied.highest == unbounded || !(varied.lowest < varied.highest)) {
    return request_problem(pointer, "required-input-missing",
                           name + " has no two bounds of its own, so they are given here: [lowest, highest]");
  }
  if (!std::isfinite(varied.highest - varied.lowest)) {
    return request_problem(
        pointer, "out-of-range",
        "the bounds of " + name + " are too far from each other; give nearer ones: [lowest, highest]");
  }
  if (auto fault = fault_in_start(varied, parameters)) return *std::move(fault);
  varied.start = std::clamp(varied.start, varied.lowest, varied.highest);
  return varied;
}

}  // namespace

Result<std::vector<Varied>> read_varied(const Json& vary, const Json& interface, const Json& parameters) {
  if (vary.empty()) {
    return request_problem("/vary", "required-input-missing",
                           "vary names no parameter that may change; " + list_of(numbers_in(interface)));
  }
  if (vary.size() > most_varied) {
    return request_problem("/vary", "limit-exceeded",
                           std::to_string(vary.size()) + " parameters are to vary, at most " +
                               std::to_string(most_varied) + " are accepted");
  }
  std::vector<Varied> varied;
  Problems problems;
  for (const auto& [name, bounds] : vary.items()) {
    Problems faults = faults_in_name(name, interface, "/vary/" + pointer_token(name));
    if (faults.empty()) {
      const Result<Varied> read = read_one(name, bounds, properties_of(interface).at(name), parameters);
      if (read) {
        varied.push_back(*read);
        continue;
      }
      faults = read.problems();
    }
    problems.insert(problems.end(), faults.begin(), faults.end());
  }
  if (!problems.empty()) return problems;
  return varied;
}

Result<std::vector<Varied>> read_differentiated(const std::vector<std::string>& names, const Json& interface,
                                                const Json& parameters) {
  const std::vector<std::string> known = numbers_in(interface);
  const std::vector<std::string>& wanted = names.empty() ? known : names;
  if (wanted.empty()) return request_problem("/by", "required-input-missing", list_of(known));
  if (wanted.size() > most_varied) {
    return request_problem("/by", "limit-exceeded",
                           std::to_string(wanted.size()) + " parameters are listed, at most " +
                               std::to_string(most_varied) + " are accepted");
  }
  std::vector<Varied> varied;
  Problems problems;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Problems faults = faults_in_name(wanted[i], interface, "/by/" + std::to_string(i));
    problems.insert(problems.end(), faults.begin(), faults.end());
    if (faults.empty()) varied.push_back(own_bounds(wanted[i], properties_of(interface).at(wanted[i]), parameters));
  }
  if (!problems.empty()) return problems;
  return varied;
}

Json setting_at(const std::vector<Varied>& varied, const Place& place) {
  Json setting = Json::object();
  for (std::size_t k = 0; k < varied.size(); ++k) {
    const auto& [name, lowest, highest, start] = varied[k];
    // The ends exactly, whatever rounding says.
    setting[name] = place[k] >= 1 ? highest : std::min(highest, lowest + place[k] * (highest - lowest));
  }
  return setting;
}

Place start_of(const std::vector<Varied>& varied) {
  Place place;
  for (const Varied& each : varied) place.push_back((each.start - each.lowest) / (each.highest - each.lowest));
  return place;
}

}  // namespace dini::fitting
