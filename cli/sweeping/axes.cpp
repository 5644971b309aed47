#include "cli/sweeping/axes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/number_in.h"
#include "cli/problems.h"

namespace dini::cli {
namespace {

constexpr std::size_t most_values = 1'000'000;

/// Whole numbers as such: parameters that are integers take no others.
Json as_json(double value) {
  constexpr double largest_exact_integer = 9007199254740992;  // 2^53
  if (value != std::floor(value) || std::abs(value) > largest_exact_integer) return value;
  return static_cast<std::int64_t>(value);
}

/// `0:2:9`
std::optional<Json> range_of(const std::string& text) {
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return std::nullopt;
  const std::string_view whole(text);
  const auto from = number_in<double>(whole.substr(0, first));
  const auto to = number_in<double>(whole.substr(first + 1, second - first - 1));
  const auto count = number_in<std::size_t>(whole.substr(second + 1));
  if (!from || !to || !std::isfinite(*to - *from)) return std::nullopt;
  if (!count || *count == 0 || *count > most_values) return std::nullopt;
  Json values = Json::array();
  for (std::size_t i = 0; i < *count; ++i) {
    const double share = *count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(*count - 1);
    values.push_back(as_json(i + 1 == *count && *count > 1 ? *to : *from + share * (*to - *from)));
  }
  return values;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    if (!quoted && (c == '[' || c == '{')) ++depth;
    if (!quoted && (c == ']' || c == '}')) --depth;
    if (c == ',' && depth <= 0 && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Json list_of(const std::string& text, const Limits& limits) {
  Json values = Json::array();
  for (const std::string& part : split(text)) {
    const auto value = parse_json(part, limits);
    values.push_back(value ? *value : Json(part));
  }
  return values;
}

}  // namespace

Result<Json> read_axes(const std::vector<std::string>& grids, const std::vector<std::string>& lists,
                       const Limits& limits) {
  Json axes = Json::object();
  const auto add = [&](const std::string& word, const std::string& option, auto values_of,
                       const std::string& accepted) -> Problems {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == word.size()) {
      return {usage_problem(option + " takes " + accepted + ", not '" + word + "'")};
    }
    const std::string name = word.substr(0, equals);
    if (axes.contains(name)) return {usage_problem("the values of '" + name + "' are given twice")};
    std::optional<Json> values = values_of(word.substr(equals + 1));
    if (!values) return {usage_problem(option + " takes " + accepted + ", not '" + word + "'")};
    axes[name] = *std::move(values);
    return {};
  };
  for (const std::string& word : grids) {
    const auto ranges = [](const std::string& text) { return range_of(text); };
    if (Problems wrong = add(word, "--grid", ranges, "NAME=FROM:TO:COUNT, as in reach=0:2:9"); !wrong.empty()) {
      return wrong;
    }
  }
  for (const std::string& word : lists) {
    const auto listed = [&](const std::string& text) { return std::optional(list_of(text, limits)); };
    if (Problems wrong = add(word, "--list", listed, "NAME=VALUE,VALUE,..."); !wrong.empty()) return wrong;
  }
  if (axes.empty())
    return usage_problem("a sweep needs the values of a parameter: --grid NAME=FROM:TO:COUNT or --list NAME=A,B");
  return axes;
}

std::string name_of_value(const Json& value) {
  std::string name = value.is_string() ? value.get<std::string>() : dump(value);
  std::ranges::replace(name, '/', '_');
  return name;
}

}  // namespace dini::cli
