#include "fitting/gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fitting/model.h"
#include "graph/request_problem.h"
#include "graph/stopped.h"

namespace dini::fitting {
namespace {

/// The longer step, in proportion to the range of a parameter: what bends within it is of the fourth power after the
/// two steps are put together, and the digits that the difference costs are five.
constexpr double longer_step = 2e-4;
/// Of a value, in proportion to the largest of its output: what evaluating rounds away.
constexpr double rounding = 4e-15;

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
  if (!exported) {
    Problems problems = exported.problems();
    for (Problem& problem : problems) {
      if (problem.in_request) problem.pointer = "/of";
    }
    return problems;
  }
  values.places = *std::move(exported);
  return values;
}

/// What is asked, read without evaluating.
struct Asked {
  std::vector<Varied> varied;
  ValuesRequest values;
  std::vector<Stencil> stencils;  ///< of each parameter
  std::size_t bytes = 0;          ///< predicted for one evaluation

  std::size_t settings() const {
    std::size_t count = 1;
    for (const Stencil& stencil : stencils) count += parts_of(stencil).size();
    return count;
  }
};

Result<Asked> read(const Engine& engine, const GradientRequest& request, const Cancel& cancel) {
  const ValueSource* source = engine.value_source();
  if (source == nullptr) return request_problem("", "internal", "this engine has no values to differentiate");
  const Result<Json> interface = engine.interface(*request.graph);
  if (!interface) return interface.problems();
  Asked asked;
  auto varied = read_differentiated(request.by, *interface, request.parameters);
  if (!varied) return varied.problems();
  auto values = request_of(*source, request);
  if (!values) return values.problems();
  asked.varied = *std::move(varied);
  asked.values = *std::move(values);
  for (const Varied& each : asked.varied) asked.stencils.push_back(stencil_of(each, range_of(each)));
  const auto bytes = memory_of_one(engine, asked.values, Json::object(), cancel);
  if (!bytes) return at_own_places(bytes.problems());
  asked.bytes = *bytes;
  return asked;
}

/// Where the values are not differentiated: one of another type, or more slopes than the limit of memory lets be kept.
std::optional<Problem> fault_in(const Asked& asked, const std::vector<Value>& values, std::size_t limit) {
  constexpr std::size_t bytes_of_slope = 48;  // as a number, and as text in an answer
  std::size_t slopes = 0;
  for (std::size_t place = 0; place < values.size(); ++place) {
    if (!is_differentiated(values[place].type())) {
      return request_problem("/of/" + std::to_string(place), "type-mismatch",
                             asked.values.places[place] + " is of type " + std::string(name(values[place].type())) +
                                 "; accepted are numbers, vectors, points and meshes");
    }
    slopes += all_numbers(values[place]).size() * asked.varied.size();
  }
  if (slopes <= limit / bytes_of_slope) return std::nullopt;
  return request_problem("/by", "limit-exceeded",
                         "there would be " + std::to_string(slopes) + " derivatives, at most " +
                             std::to_string(limit / bytes_of_slope) +
                             " are accepted; name fewer parameters, or smaller outputs");
}

/// Derivatives by the parameters [begin, end), whose evaluations are one family.
Problems add_derivatives(const Asked& asked, std::size_t begin, std::size_t end, const ValueSource& source,
                         const Cancel& cancel, Gradient& gradient) {
  std::vector<Json> settings;
  for (std::size_t k = begin; k < end; ++k) {
    for (const double part : parts_of(asked.stencils[k])) {
      settings.push_back({{asked.varied[k].name, asked.varied[k].start + part * asked.stencils[k].step}});
    }
  }
  const auto values = source.values(asked.values, settings, cancel);
  if (!values) return values.problems();
  for (const SettingValues& each : *values) {
    if (!each) return at_own_places(each.problems());
  }
  for (std::size_t place = 0; place < gradient.outputs.size(); ++place) {
    Differentiated& output = gradient.outputs[place];
    const std::vector<double> numbers = all_numbers(output.value);
    std::size_t setting = 0;
    for (std::size_t k = begin; k < end; ++k) {
      std::vector<std::vector<double>> moved;
      for (std::size_t part = 0; part < parts_of(asked.stencils[k]).size(); ++part) {
        moved.push_back(all_numbers((*(*values)[setting++])[place]));
      }
      auto found = derivative(asked.stencils[k], numbers, moved);
      if (!found) {
        return {request_problem(
            "/of/" + std::to_string(place), "degenerate",
            output.place + " has no derivative by " + asked.varied[k].name +
                " here: within a small step it gets another number of values, or one that is not finite")};
      }
      output.by.push_back(*std::move(found));
    }
  }
  return {};
}

}  // namespace

Result<std::size_t> check(const Engine& engine, const GradientRequest& request, const Cancel& cancel) {
  const Result<Asked> asked = read(engine, request, cancel);
  if (!asked) return asked.problems();
  return std::min(engine.limits().request_bytes, asked->settings() * asked->bytes);
}

Result<Gradient> gradient(const Engine& engine, const GradientRequest& request, const Cancel& cancel) {
  const Result<Asked> asked = read(engine, request, cancel);
  if (!asked) return asked.problems();
  const ValueSource& source = *engine.value_source();
  const std::size_t limit = engine.limits().request_bytes;
  const Json here = Json::object();
  const auto first = source.values(asked->values, std::span(&here, 1), cancel);
  if (!first) return first.problems();
  if (!first->front()) return at_own_places(first->front().problems());
  const std::vector<Value>& values = *first->front();
  if (auto fault = fault_in(*asked, values, limit)) return *std::move(fault);
  Gradient gradient;
  for (const Varied& each : asked->varied) {
    gradient.parameters.push_back(each.name);
    gradient.at.push_back(each.start);
    gradient.ranges.push_back(range_of(each));
  }
  for (std::size_t place = 0; place < values.size(); ++place) {
    gradient.outputs.push_back({asked->values.places[place], values[place], {}});
  }
  const std::size_t most_settings = limit / std::max<std::size_t>(1, asked->bytes);
  for (std::size_t begin = 0, end = 0; begin < asked->varied.size(); begin = end) {
    std::size_t settings = 0;
    do {
      settings += parts_of(asked->stencils[end++]).size();
    } while (end < asked->varied.size() && settings + central.size() <= most_settings);
    if (Problems problems = add_derivatives(*asked, begin, end, source, cancel, gradient); !problems.empty()) {
      return problems;
    }
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
