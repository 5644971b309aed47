#include "fitting/gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fitting/model.h"
#include "graph/stopped.h"

namespace dini::fitting {
namespace {

/// The longer step, in proportion to the range of a parameter: what bends within it is of the fourth power after the
/// two steps are put together, and the digits that the difference costs are five.
constexpr double longer_step = 2e-4;
/// Of a value, in proportion to the largest of its output: what evaluating rounds away.
constexpr double rounding = 4e-15;

Problem wrong(std::string pointer, std::string code, std::string detail) {
  return {.code = std::move(code), .detail = std::move(detail), .pointer = std::move(pointer), .in_request = true};
}

/// The values that a difference is made of: the parameter is moved by these parts of its longer step.
struct Stencil {
  double step = 0;  ///< with its sign where it is one-sided
  bool is_central = true;
};

constexpr std::array central = {0.5, -0.5, 1.0, -1.0};
constexpr std::array one_sided = {0.5, 1.0, 2.0};

std::span<const double> parts_of(const Stencil& stencil) {
  if (stencil.is_central) return central;
  return one_sided;
}

Stencil stencil_of(const Varied& varied, double range) {
  const double step = longer_step * range;
  const bool has_below = varied.start - step >= varied.lowest, has_above = varied.start + step <= varied.highest;
  if (has_below && has_above) return {step, true};
  return {has_above ? step : -step, false};
}

double range_of(const Varied& varied) {
  const double range = varied.highest - varied.lowest;
  if (std::isfinite(range)) return range;
  return std::max(1.0, std::abs(varied.start));
}

/// The derivative of one number from its value and those of the stencil, with how far the two steps are apart.
std::pair<double, double> slope_of(const Stencil& stencil, double value, std::span<const double> moved) {
  const double h = stencil.step;
  double shorter = 0, longer = 0;
  if (stencil.is_central) {
    shorter = (moved[0] - moved[1]) / h;
    longer = (moved[2] - moved[3]) / (2 * h);
  } else {
    shorter = (-3 * value + 4 * moved[0] - moved[1]) / h;
    longer = (-3 * value + 4 * moved[1] - moved[2]) / (2 * h);
  }
  return {shorter + (shorter - longer) / 3, std::abs(shorter - longer) / 3};
}

/// All numbers of a value, those of the vertices of meshes too.
std::vector<double> all_numbers(const Value& value) {
  if (value.type() != WireType::mesh) return numbers_of(value).value_or(std::vector<double>());
  std::vector<double> numbers;
  const Column<SharedMesh>& meshes = column_of<SharedMesh>(value);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto& positions = meshes[i]->positions;
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const Vector position = to_vector(positions[k]);
      numbers.insert(numbers.end(), {position.x, position.y, position.z});
    }
  }
  return numbers;
}

bool is_differentiated(WireType type) {
  return type == WireType::number || type == WireType::vector || type == WireType::point || type == WireType::mesh;
}

/// The derivative of one output; nothing where it has another number of numbers within a step, or is not finite.
std::optional<Derivative> derivative(const Stencil& stencil, const std::vector<double>& values,
                                     const std::vector<std::vector<double>>& moved) {
  Derivative found;
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  for (const auto& each : moved) {
    if (each.size() != values.size()) return std::nullopt;
  }
  std::vector<double> there(moved.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < moved.size(); ++k) there[k] = moved[k][i];
    const auto [slope, error] = slope_of(stencil, values[i], there);
    if (!std::isfinite(slope)) return std::nullopt;
    found.slopes.push_back(slope);
    found.error = std::max(found.error, error);
  }
  found.error += rounding * largest / std::abs(stencil.step) * 8;
  return found;
}

Problems at_own_places(Problems problems) {
  constexpr std::string_view measures = "/measures";
  for (Problem& problem : problems) {
    if (problem.in_request && problem.pointer && problem.pointer->starts_with(measures)) {
      problem.pointer = "/of" + problem.pointer->substr(measures.size());
    }
  }
  return problems;
}

Result<ValuesRequest> request_of(const ValueSource& source, const GradientRequest& request) {
  ValuesRequest values{.graph = request.graph, .parameters = request.parameters, .places = request.of};
  if (!values.places.empty()) return values;
  auto exported = source.exported_places(*request.graph);
  if (!exported) return exported.problems();
  values.places = *std::move(exported);
  return values;
}

}  // namespace

Result<Gradient> gradient(const Engine& engine, const GradientRequest& request, const Cancel& cancel) {
  const ValueSource* source = engine.value_source();
  if (source == nullptr) return wrong("", "internal", "this engine has no values to differentiate");
  const Result<Json> interface = engine.interface(*request.graph);
  if (!interface) return interface.problems();
  const auto varied = read_differentiated(request.by, *interface, request.parameters);
  if (!varied) return varied.problems();
  const auto asked = request_of(*source, request);
  if (!asked) return asked.problems();
  Gradient gradient;
  std::vector<Stencil> stencils;
  std::vector<Json> settings = {Json::object()};
  for (const Varied& each : *varied) {
    gradient.parameters.push_back(each.name);
    gradient.at.push_back(each.start);
    gradient.ranges.push_back(range_of(each));
    stencils.push_back(stencil_of(each, gradient.ranges.back()));
    for (const double part : parts_of(stencils.back())) {
      settings.push_back({{each.name, each.start + part * stencils.back().step}});
    }
  }
  const auto values = source->values(*asked, settings, cancel);
  if (!values) return values.problems();
  for (const SettingValues& each : *values) {
    if (!each) return at_own_places(each.problems());
  }
  for (std::size_t place = 0; place < asked->places.size(); ++place) {
    Differentiated output{asked->places[place], (*values->front())[place], {}};
    if (!is_differentiated(output.value.type())) {
      return wrong("/of/" + std::to_string(place), "type-mismatch",
                   output.place + " is of type " + std::string(name(output.value.type())) +
                       "; accepted are numbers, vectors, points and meshes");
    }
    const std::vector<double> numbers = all_numbers(output.value);
    std::size_t setting = 1;
    for (std::size_t k = 0; k < varied->size(); ++k) {
      std::vector<std::vector<double>> moved;
      for (std::size_t part = 0; part < parts_of(stencils[k]).size(); ++part) {
        moved.push_back(all_numbers((*(*values)[setting++])[place]));
      }
      auto found = derivative(stencils[k], numbers, moved);
      if (!found) {
        return wrong("/of/" + std::to_string(place), "degenerate",
                     output.place + " has no derivative by " + gradient.parameters[k] +
                         " here: within a small step it gets another number of values, or one that is not finite");
      }
      output.by.push_back(*std::move(found));
    }
    gradient.outputs.push_back(std::move(output));
  }
  return gradient;
}

Json to_json(const Gradient& gradient) {
  Json at = Json::object(), outputs = Json::object();
  for (std::size_t k = 0; k < gradient.parameters.size(); ++k) at[gradient.parameters[k]] = gradient.at[k];
  for (const Differentiated& output : gradient.outputs) {
    const bool has_parts = output.value.type() != WireType::number;
    Json by = Json::object();
    for (std::size_t k = 0; k < gradient.parameters.size(); ++k) {
      const Derivative& derivative = output.by[k];
      Json values = Json::array();
      for (std::size_t i = 0; i < derivative.slopes.size(); i += has_parts ? 3 : 1) {
        if (has_parts) {
          values.push_back({derivative.slopes[i], derivative.slopes[i + 1], derivative.slopes[i + 2]});
        } else {
          values.push_back(derivative.slopes[i]);
        }
      }
      by[gradient.parameters[k]] = {{"values", std::move(values)}, {"error", derivative.error}};
    }
    outputs[output.place] = {{"type", name(output.value.type())}, {"by", std::move(by)}};
  }
  return {{"at", std::move(at)}, {"of", std::move(outputs)}};
}

}  // namespace dini::fitting
