#include "server/description_tables.h"

#include <algorithm>
#include <array>
#include <map>

#include "server/responses.h"
#include "server/server_limits.h"
#include "service/requests/results.h"

namespace dini::server {
namespace {

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string joined(const std::vector<std::string>& words, std::string_view separator = ", ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : std::string(separator)) + word;
  return text;
}

std::string type_words(const Member& member) {
  if (member.kind == MemberKind::graph) return "a graph document or a name";
  if (member.choices.empty()) return words_for(member.kind);
  std::vector<std::string> choices;
  for (const std::string& choice : member.choices) choices.push_back(code(choice));
  return joined(choices, " or ");
}

std::string default_words(const MemberSpec& spec) {
  if (spec.is_required) return "must be given";
  return spec.default_value.is_null() ? spec.when_missing : code(spec.default_value.dump());
}

/// Units that are written behind a number; the others are names of what is counted.
bool is_measure(std::string_view unit) { return unit.starts_with("bytes") || unit == "ms" || unit == "ns"; }

/// 1048576 bytes as "1 MiB", 12345 ms as "12,345 ms", 12345 nodes as "12,345".
std::string number_words(std::uint64_t number, std::string_view unit) {
  constexpr std::array<std::pair<std::uint64_t, std::string_view>, 3> units = {
      {{std::uint64_t{1} << 30, "GiB"}, {std::uint64_t{1} << 20, "MiB"}, {std::uint64_t{1} << 10, "KiB"}}};
  for (const auto& [size, name] : units) {
    if (!unit.starts_with("bytes") || number < size || number % size != 0) continue;
    return std::to_string(number / size) + " " + std::string(name) + std::string(unit.substr(5));
  }
  std::string digits = std::to_string(number);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return is_measure(unit) ? digits + " " + std::string(unit) : digits;
}

std::string range_words(const MemberSpec& spec) {
  const auto number = [](std::int64_t value) { return number_words(static_cast<std::uint64_t>(value), ""); };
  std::string text;
  if (spec.least && spec.most) {
    text = number(*spec.least) + " to " + number(*spec.most);
  } else if (spec.least) {
    text = "from " + number(*spec.least);
  } else if (spec.most) {
    text = "up to " + number(*spec.most);
  }
  return text.empty() || spec.unit_text.empty() ? text : text + " " + spec.unit_text;
}

/// The name of the component that a schema refers to; empty when it refers to none.
std::string component_of(const Json& schema) {
  const std::string reference = schema.value("$ref", "");
  return reference.substr(reference.rfind('/') + 1);
}

/// "list of `Axis`", "text": what a schema takes, in words.
std::string type_words(const Json& schema) {
  if (schema.contains("$ref")) return code(component_of(schema));
  const std::string type = schema.value("type", "");
  if (type == "array") return "list of " + type_words(schema["items"]);
  if (type == "object" && schema.value("additionalProperties", Json()).is_object()) {
    return "object of " + type_words(schema["additionalProperties"]) + " by name";
  }
  if (type == "string") return "text";
  if (type == "integer") return "whole number";
  return type.empty() ? "anything" : type;
}

template <class Owner>
void add_limits(std::span<const Limit<Owner>> limits, Table& table) {
  for (const Limit<Owner>& limit : limits) {
    const std::string usual =
        limit.zero_means.empty() ? number_words(limit.get(Owner{}), limit.unit) : std::string(limit.zero_means);
    const std::string counted = is_measure(limit.unit) ? "" : std::string(limit.unit) + " ";
    table.rows.push_back({code(limit.name), usual, counted + std::string(limit.doc),
                          code(flag_of(limit.name)) + " " + code(variable_of(limit.name))});
  }
}

}  // namespace

Table routes_table(std::span<const Route> routes) {
  Table table{{"method, address", "does"}, {}};
  for (const Route& route : routes) {
    const Operation operation = route.describe();
    table.rows.push_back({code(std::string(route.method) + " " + std::string(route.path)), operation.title});
  }
  return table;
}

Table members_table(const RequestDescription& request) {
  Table table{{"member", "type", "left out", "range", "what it is"}, {}};
  for (const Member& member : request.members) {
    table.rows.push_back(
        {code(member.name), type_words(member), default_words(member.spec), range_words(member.spec), member.doc});
  }
  return table;
}

Table parameters_table(const Operation& operation) {
  Table table{{"name", "in", "what it is"}, {}};
  for (const Parameter& parameter : operation.parameters) {
    table.rows.push_back({code(parameter.name), std::string(name_of(parameter.place)), parameter.doc});
  }
  return table;
}

Table answers_table(const Operation& operation) {
  Table table{{"status", "media type", "headers", "what it is"}, {}};
  for (const Answer& answer : operation.answers) {
    std::vector<std::string> types, headers;
    for (const Content& content : answer.contents) types.push_back(code(content.type));
    for (const std::string& header : answer.headers) headers.push_back(code(header));
    table.rows.push_back({std::to_string(answer.status), joined(types), joined(headers), answer.doc});
  }
  return table;
}

Table schema_table(const Json& schema) {
  Table table{{"member", "type", "what it is"}, {}};
  const Json whole = schema.contains("$ref") ? result_schemas().value(component_of(schema), Json::object()) : schema;
  const Json required = whole.value("required", Json::array());
  const Json properties = whole.value("properties", Json::object());
  for (const auto& [name, member] : properties.items()) {
    const bool always = std::ranges::find(required, Json(name)) != required.end();
    table.rows.push_back(
        {code(name), type_words(member) + (always ? "" : ", or left out"), member.value("description", "")});
  }
  return table;
}

Table operation_problems_table(const Route& route, const Operation& operation) {
  std::map<int, std::vector<std::string>> statuses;
  for (const std::string_view name : every_problem(operation, route.method, route.path)) {
    statuses[find_problem_code(name)->status].push_back(code(name));
  }
  Table table{{"status", "codes"}, {}};
  for (const auto& [status, codes] : statuses) table.rows.push_back({std::to_string(status), joined(codes)});
  return table;
}

Table limits_table() {
  Table table{{"limit", "default", "what it bounds", "set by"}, {}};
  add_limits(evaluation_limits(), table);
  add_limits(server_limits(), table);
  return table;
}

Table codes_table(ProblemKind kind) {
  Table table{{"code", "status", "meaning"}, {}, "problems"};
  for (const ProblemCode& known : problem_codes()) {
    if (known.kind != kind) continue;
    table.rows.push_back(
        {code(known.code), known.status == 0 ? "" : std::to_string(known.status), std::string(known.meaning)});
  }
  return table;
}

Table statuses_table() {
  std::map<int, std::vector<std::string_view>> statuses;
  for (const ProblemCode& known : problem_codes()) {
    if (known.status != 0) statuses[known.status].push_back(known.code);
  }
  Table table{{"status", "title", "codes"}, {}};
  for (const auto& [status, codes] : statuses) {
    std::vector<std::string> marked;
    for (const std::string_view each : codes) marked.push_back(code(each));
    const std::string title = title_of_code(codes.front());
    const bool of_all = title == title_of_code(codes.back());
    table.rows.push_back({std::to_string(status), of_all ? title : "the words of the code", joined(marked, " ")});
  }
  return table;
}

Table headers_table() {
  Table table{{"header", "meaning"}, {}};
  for (const AnswerHeader& header : answer_headers())
    table.rows.push_back({code(header.name), std::string(header.doc)});
  return table;
}

}  // namespace dini::server
