#include "service/requests/member.h"

#include <algorithm>
#include <cmath>

#include "graph/json_reader.h"
#include "service/requests/excerpt.h"
#include "service/requests/schema.h"

namespace dini {
namespace {

Problem fault(const Member& member, std::string code, std::string detail) {
  return {.code = std::move(code),
          .detail = std::move(detail),
          .pointer = "/" + pointer_token(member.name),
          .in_request = true};
}

bool is_whole(const Json& value) { return value.is_number() && value.get<double>() == std::floor(value.get<double>()); }

bool has_kind(MemberKind kind, const Json& value) {
  switch (kind) {
    case MemberKind::graph:
    case MemberKind::object:
      return value.is_object();
    case MemberKind::text:
    case MemberKind::choice:
      return value.is_string();
    case MemberKind::boolean:
      return value.is_boolean();
    case MemberKind::integer:
      return is_whole(value);
    case MemberKind::texts:
      return value.is_array() && std::ranges::all_of(value, [](const Json& item) { return item.is_string(); });
    case MemberKind::objects:
      return value.is_array() && std::ranges::all_of(value, [](const Json& item) { return item.is_object(); });
  }
  return false;
}

std::string range_words(const MemberSpec& spec) {
  if (!spec.most) return "at least " + std::to_string(*spec.least);
  if (!spec.least) return "at most " + std::to_string(*spec.most);
  return std::to_string(*spec.least) + " to " + std::to_string(*spec.most);
}

std::optional<Problem> out_of_range(const Member& member, const Json& value) {
  const auto number = value.get<double>();
  std::optional<std::int64_t> nearest;
  if (member.spec.least && number < static_cast<double>(*member.spec.least)) nearest = member.spec.least;
  if (member.spec.most && number > static_cast<double>(*member.spec.most)) nearest = member.spec.most;
  if (!nearest) return std::nullopt;
  Problem problem = fault(member, "out-of-range", "'" + member.name + "' must be " + range_words(member.spec) + ".");
  problem.fix = {{{"op", "replace"}, {"path", *problem.pointer}, {"value", *nearest}}};
  return problem;
}

}  // namespace

std::string words_for(MemberKind kind) {
  switch (kind) {
    case MemberKind::graph:
      return "a graph document";
    case MemberKind::object:
      return "an object";
    case MemberKind::boolean:
      return "true or false";
    case MemberKind::integer:
      return "a whole number";
    case MemberKind::texts:
      return "a list of texts";
    case MemberKind::objects:
      return "a list of objects";
    case MemberKind::text:
    case MemberKind::choice:
      break;
  }
  return "text";
}

Json schema_of(const Member& member) {
  if (member.kind == MemberKind::graph) {
    const Json name = {{"type", "string"}, {"pattern", schema::graph_name_pattern(true)}};
    return {{"anyOf", {{{"$ref", "#/components/schemas/Graph"}}, name}}, {"description", member.doc}};
  }
  static const char* const types[] = {"object", "object", "string", "string", "boolean", "integer", "array", "array"};
  Json schema = {{"type", types[static_cast<std::size_t>(member.kind)]}, {"description", member.doc}};
  if (member.kind == MemberKind::object) schema["additionalProperties"] = true;
  if (member.kind == MemberKind::texts) schema["items"] = {{"type", "string"}};
  if (member.kind == MemberKind::objects) schema["items"] = {{"type", "object"}};
  if (!member.choices.empty()) schema["enum"] = member.choices;
  if (member.spec.least) schema["minimum"] = *member.spec.least;
  if (member.spec.most) schema["maximum"] = *member.spec.most;
  if (!member.spec.default_value.is_null()) schema["default"] = member.spec.default_value;
  if (!member.spec.example_value.is_null()) schema["examples"] = Json::array({member.spec.example_value});
  return schema;
}

std::optional<Problem> fault_in(const Member& member, const Json& value) {
  if (!has_kind(member.kind, value)) {
    return fault(member, "type-mismatch", "'" + member.name + "' must be " + words_for(member.kind) + ".");
  }
  if (member.kind == MemberKind::integer) return out_of_range(member, value);
  if (member.kind != MemberKind::choice) return std::nullopt;
  const auto& word = value.get_ref<const std::string&>();
  if (std::ranges::find(member.choices, word) != member.choices.end()) return std::nullopt;
  return fault(member, "not-in-choices",
               "'" + text_excerpt(word) + "' is none of " + quoted_list(member.choices) + ".");
}

}  // namespace dini
