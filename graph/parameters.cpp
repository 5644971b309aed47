#include "graph/parameters.h"

#include <algorithm>
#include <array>

#include "graph/fixes.h"
#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/names.h"
#include "graph/nearest.h"

namespace dini {

namespace {

constexpr std::array parameter_types = {WireType::number, WireType::integer, WireType::boolean,
                                        WireType::choice, WireType::vector,  WireType::color};

std::optional<WireType> parameter_type(const Json& json) {
  if (!json.is_string()) return std::nullopt;
  for (const WireType type : parameter_types) {
    if (json.get_ref<const std::string&>() == name(type)) return type;
  }
  return std::nullopt;
}

/// What a sentence calls a parameter: its name, and its label where it has one.
std::string named(const std::string& name, const Parameter& parameter) {
  return parameter.label && *parameter.label != name ? name + " (" + *parameter.label + ")" : name;
}

Problem unknown_parameter(const Document& document, const Json& given, const std::string& name) {
  const std::string pointer = "/parameters/" + pointer_token(name);
  const std::vector<std::string> known = keys_of(document.parameters);
  const std::string near = nearest(name, known);
  return {"unknown-parameter",
          "the graph has no parameter " + excerpt(name) + did_you_mean(name, known),
          "",
          "",
          pointer,
          near.empty() || given.contains(near)
              ? Json{{{"op", "remove"}, {"path", pointer}}}
              : Json{{{"op", "move"}, {"from", pointer}, {"path", "/parameters/" + near}}},
          true};
}

/// Collects the problems of one parameter.
class ParameterReader {
 public:
  ParameterReader(const Json& json, std::string pointer) : json_(json), pointer_(std::move(pointer)) {}

  Result<Parameter> read() {
    if (!json_.is_object()) return Problem{"type-mismatch", "a parameter must be an object", "", "", pointer_};
    refuse_unknown();
    const std::optional<WireType> type = parameter_type(json_.value("type", Json()));
    if (!type) {
      add("type", "type must be number, integer, boolean, choice, vector or color");
      return problems_;
    }
    parameter_.type = *type;
    parameter_.minimum = number("min");
    parameter_.maximum = number("max");
    parameter_.step = number("step");
    read_limits();
    parameter_.unit = text("unit");
    parameter_.label = text("label");
    parameter_.description = text("description");
    read_choices();
    read_default();
    if (!problems_.empty()) return problems_;
    return parameter_;
  }

 private:
  void add(const std::string& member, std::string detail, std::string code = "type-mismatch", Json fix = nullptr) {
    problems_.push_back(
        {std::move(code), std::move(detail), "", "", pointer_ + "/" + pointer_token(member), std::move(fix)});
  }

  void refuse_unknown() {
    static const std::vector<std::string> known = {"type", "default", "min",         "max",    "step",
                                                   "unit", "label",   "description", "choices"};
    for (const auto& [member, value] : json_.items()) {
      if (std::find(known.begin(), known.end(), member) != known.end()) continue;
      add(member, "unknown member " + excerpt(member) + did_you_mean(member, known), "unknown-member");
    }
  }

  std::optional<double> number(const char* member) {
    if (!json_.contains(member)) return std::nullopt;
    if (!json_[member].is_number()) {
      add(member, std::string(member) + " must be a number");
      return std::nullopt;
    }
    return json_[member].get<double>();
  }

  bool no_value_fits() const {
    return parameter_.minimum && parameter_.maximum && *parameter_.minimum > *parameter_.maximum;
  }

  void read_limits() {
    if (no_value_fits()) {
      add("min", "min is " + to_text(*parameter_.minimum) + ", above max, which is " + to_text(*parameter_.maximum),
          "out-of-range");
    }
    if (parameter_.step && !(*parameter_.step > 0)) {
      add("step", "got " + to_text(*parameter_.step) + ", a step is above 0", "out-of-range");
    }
  }

  std::optional<std::string> text(const char* member) {
    if (!json_.contains(member)) return std::nullopt;
    if (!json_[member].is_string()) {
      add(member, std::string(member) + " must be a text");
      return std::nullopt;
    }
    return json_[member].get<std::string>();
  }

  void read_choices() {
    const Json choices = json_.value("choices", Json::array());
    const bool texts = choices.is_array() &&
                       std::all_of(choices.begin(), choices.end(), [](const Json& word) { return word.is_string(); });
    if (!texts || (choices.empty() == (parameter_.type == WireType::choice))) {
      add("choices", "a choice lists its words in \"choices\", other types have none");
      return;
    }
    parameter_.choices = choices.get<std::vector<std::string>>();
  }

  void read_default() {
    if (!json_.contains("default")) {
      problems_.push_back({"required-member-missing", "the parameter has no \"default\"", "", "", pointer_});
      return;
    }
    if (no_value_fits()) return;  // what is said of the limits is enough
    const Json& written = json_["default"];
    const InputPort port = parameter_port(parameter_);
    LiteralResult read = read_literal(written, parameter_.type, port);
    if (read) {
      parameter_.default_value = {written, *std::move(read)};
      return;
    }
    const auto& [code, detail] = read.error();
    add("default", detail, code, acceptable_literal(pointer_ + "/default", code, written, port));
  }

  const Json& json_;
  std::string pointer_;
  Parameter parameter_;
  Problems problems_;
};

}  // namespace

InputPort parameter_port(const Parameter& parameter) {
  InputPort port;
  port.spec.minimum = parameter.minimum;
  port.spec.maximum = parameter.maximum;
  port.choices = parameter.choices;
  port.types = {parameter.type};
  return port;
}

Result<Parameter> read_parameter(const Json& json, const std::string& pointer) {
  return ParameterReader(json, pointer).read();
}

ParameterValues usual_parameters(const Document& document) {
  ParameterValues values;
  for (const auto& [name, parameter] : document.parameters) values.emplace(name, parameter.default_value);
  return values;
}

Result<ParameterValues> resolve_parameters(const Document& document, const Json& given) {
  ProblemCollector problems;
  ParameterValues values = usual_parameters(document);
  if (!given.is_object())
    return Problem{
        "type-mismatch", "parameters must be an object of values by name", "", "", "/parameters", nullptr, true};
  for (const auto& [name, value] : given.items()) {
    const auto parameter = document.parameters.find(name);
    if (parameter == document.parameters.end()) {
      problems.add([&, &unknown = name] { return unknown_parameter(document, given, unknown); });
      continue;
    }
    const InputPort port = parameter_port(parameter->second);
    LiteralResult read = read_literal(value, parameter->second.type, port);
    if (!read) {
      const LiteralProblem& problem = read.error();
      problems.add([&, &wrong = name, &refused = value] {
        const std::string pointer = "/parameters/" + wrong;
        return Problem{.code = problem.code,
                       .detail = named(wrong, parameter->second) + ": " + problem.detail,
                       .pointer = pointer,
                       .fix = acceptable_literal(pointer, problem.code, refused, port),
                       .in_request = true};
      });
      continue;
    }
    values[name] = {value, *std::move(read)};
  }
  if (!problems.empty()) return std::move(problems).take();
  return values;
}

}  // namespace dini
