#include "graph/literal.h"

#include <algorithm>
#include <cmath>

namespace dini {

namespace {

/// The largest whole number that no other one is rounded to.
constexpr double largest_exact_integer = 9007199254740991;

LiteralProblem mismatch(const Json& json, const std::string& accepted) {
  return {"type-mismatch", "got " + excerpt(json) + ", expected " + accepted};
}

bool outside(double value, const InputSpec& spec) {
  return (spec.minimum && value < *spec.minimum) || (spec.maximum && value > *spec.maximum);
}

LiteralProblem out_of_range(const Json& json, const InputSpec& spec) {
  return {"out-of-range", "got " + excerpt(json) + ", accepted is " + range_text(spec.minimum, spec.maximum)};
}

/// `json` is what is repeated of a value that is refused.
LiteralResult number_at(const InputPort& port, double value, const Json& json) {
  if (outside(value, port.spec)) return out_of_range(json, port.spec);
  return Argument(Value{{}, single_column(value)});
}

LiteralResult read_number(const Json& json, const InputPort& port) {
  if (!json.is_number()) return mismatch(json, "a number");
  const double value = json.get<double>();
  if (!std::isfinite(value)) return LiteralProblem{"non-finite", "the number is not finite"};
  return number_at(port, value, json);
}

LiteralResult integer_at(const InputPort& port, double value, const Json& json) {
  if (std::abs(value) > largest_exact_integer || outside(value, port.spec)) return out_of_range(json, port.spec);
  return Argument(Literal(static_cast<std::int64_t>(value)));
}

LiteralResult read_integer(const Json& json, const InputPort& port) {
  if (!json.is_number()) return mismatch(json, "a whole number");
  const double value = json.get<double>();
  if (value != std::floor(value)) return mismatch(json, "a whole number");
  return integer_at(port, value, json);
}

/// The numbers of an array of `least` to `most` finite numbers; empty when it is anything else.
std::vector<double> numbers_of(const Json& json, std::size_t least, std::size_t most) {
  if (!json.is_array() || json.size() < least || json.size() > most) return {};
  std::vector<double> numbers;
  for (const Json& item : json) {
    if (!item.is_number() || !std::isfinite(item.get<double>())) return {};
    numbers.push_back(item.get<double>());
  }
  return numbers;
}

template <class T>
LiteralResult read_triple(const Json& json) {
  const std::vector<double> numbers = numbers_of(json, 3, 3);
  if (numbers.empty()) return mismatch(json, "three finite numbers [x, y, z]");
  return Argument(Value{{}, single_column(T{numbers[0], numbers[1], numbers[2]})});
}

LiteralResult read_color(const Json& json) {
  std::vector<double> numbers = numbers_of(json, 3, 4);
  if (numbers.empty()) return mismatch(json, "a color [red, green, blue] or [red, green, blue, alpha]");
  if (std::any_of(numbers.begin(), numbers.end(), [](double n) { return n < 0 || n > 1; })) {
    return LiteralProblem{"out-of-range", "got " + excerpt(json) + ", every component must be 0 to 1"};
  }
  numbers.resize(4, 1.0);
  return Argument(Literal(Color{numbers[0], numbers[1], numbers[2], numbers[3]}));
}

std::string words_of(const InputPort& port) {
  std::string accepted;
  for (const std::string& word : port.choices) accepted += (accepted.empty() ? "" : ", ") + word;
  return accepted;
}

LiteralResult choice_at(const InputPort& port, const std::string& word, const Json& json) {
  if (std::find(port.choices.begin(), port.choices.end(), word) == port.choices.end()) {
    return LiteralProblem{"not-in-choices", "got " + excerpt(json) + ", accepted are " + words_of(port)};
  }
  return Argument(Literal(word));
}

LiteralResult read_choice(const Json& json, const InputPort& port) {
  if (!json.is_string()) return mismatch(json, "one of " + words_of(port));
  return choice_at(port, json.get_ref<const std::string&>(), json);
}

LiteralResult text_at(const InputPort& port, const std::string& text, const Json& json) {
  constexpr std::size_t longest_axis_name = 64;
  const bool control =
      std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (port.spec.is_axis_name && (text.size() > longest_axis_name || control)) {
    return LiteralProblem{"out-of-range", "got " + excerpt(json) + ", accepted are names of up to " +
                                              std::to_string(longest_axis_name) + " bytes without control characters"};
  }
  if (port.spec.is_axis_name && text.empty() && port.spec.default_value != Json("")) {
    return LiteralProblem{"out-of-range", "this axis needs a name"};
  }
  if (port.spec.text_fault) {
    if (std::optional<std::string> fault = port.spec.text_fault(text)) {
      return LiteralProblem{port.spec.text_fault_code, *std::move(fault)};
    }
  }
  return Argument(Literal(text));
}

LiteralResult read_text(const Json& json, const InputPort& port) {
  if (!json.is_string()) return mismatch(json, "a text");
  return text_at(port, json.get_ref<const std::string&>(), json);
}

/// The number or whole number that a parameter holds.
double number_of(const Argument& value) {
  if (const auto* literal = std::get_if<Literal>(&value)) return static_cast<double>(std::get<std::int64_t>(*literal));
  return column_of<double>(std::get<Value>(value))[0];
}

const std::string& text_of(const Argument& value) { return std::get<std::string>(std::get<Literal>(value)); }

}  // namespace

const LiteralResult& Readings::as(WireType type) const {
  static const LiteralResult none = LiteralProblem{};
  const auto found = std::ranges::find(each_, type, [](const auto& reading) { return reading.first; });
  return found == each_.end() ? none : found->second;
}

LiteralResult read_literal(const Json& json, WireType type, const InputPort& port) {
  switch (type) {
    case WireType::number:
      return read_number(json, port);
    case WireType::integer:
      return read_integer(json, port);
    case WireType::vector:
      return read_triple<Vector>(json);
    case WireType::point:
      return read_triple<Point>(json);
    case WireType::color:
      return read_color(json);
    case WireType::choice:
      return read_choice(json, port);
    case WireType::text:
      return read_text(json, port);
    case WireType::boolean:
      if (!json.is_boolean()) return mismatch(json, "true or false");
      return Argument(Literal(json.get<bool>()));
    case WireType::generator:
    case WireType::circle:
    case WireType::sphere:
    case WireType::mesh:
    case WireType::asset:
    case WireType::field:
      break;
  }
  return mismatch(json, "a link to a " + std::string(name(type)));
}

Readings read_literal(const Json& json, const InputPort& port) {
  Readings readings;
  for (const WireType type : port.types) readings.add(type, read_literal(json, type, port));
  return readings;
}

LiteralResult given_to(const InputPort& port, WireType type, const ParameterValue& parameter) {
  const auto& [written, value] = parameter;
  switch (type) {
    case WireType::number:
      return number_at(port, number_of(value), written);
    case WireType::integer:
      return integer_at(port, number_of(value), written);
    case WireType::choice:
      return choice_at(port, text_of(value), written);
    case WireType::text:
      return text_at(port, text_of(value), written);
    case WireType::point: {
      const Vector vector = column_of<Vector>(std::get<Value>(value))[0];
      return Argument(Value{{}, single_column(Point{vector.x, vector.y, vector.z})});
    }
    default:
      return value;
  }
}

bool has_literals(WireType type) {
  switch (type) {
    case WireType::generator:
    case WireType::circle:
    case WireType::sphere:
    case WireType::mesh:
    case WireType::asset:
    case WireType::field:
      return false;
    default:
      return true;
  }
}

std::string to_text(double value) {
  return Json(value == std::floor(value) && std::abs(value) < 1e15 ? Json(static_cast<std::int64_t>(value))
                                                                   : Json(value))
      .dump();
}

std::string range_text(std::optional<double> minimum, std::optional<double> maximum) {
  if (minimum && maximum) return to_text(*minimum) + " to " + to_text(*maximum);
  if (minimum) return "at least " + to_text(*minimum);
  if (maximum) return "at most " + to_text(*maximum);
  return "any";
}

std::string excerpt(const Json& json) {
  constexpr std::size_t longest = 60;
  if (json.is_structured() && json.size() > 8) return json.is_array() ? "a long list" : "an object";
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

}  // namespace dini
