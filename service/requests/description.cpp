#include "service/requests/description.h"

#include <algorithm>

#include "graph/json_reader.h"
#include "graph/nearest.h"
#include "service/requests/excerpt.h"

namespace dini {

const Member* RequestDescription::find(std::string_view member) const {
  const auto found = std::ranges::find(members, member, &Member::name);
  return found != members.end() ? &*found : nullptr;
}

std::vector<std::string> RequestDescription::names() const {
  std::vector<std::string> all;
  for (const Member& member : members) all.push_back(member.name);
  return all;
}

Json schema_of(const RequestDescription& request) {
  Json properties = Json::object();
  Json needed = Json::array();
  for (const Member& member : request.members) {
    properties[member.name] = schema_of(member);
    if (member.spec.is_required) needed.push_back(member.name);
  }
  Json schema = {{"type", "object"},
                 {"description", request.doc},
                 {"properties", std::move(properties)},
                 {"additionalProperties", false}};
  if (!needed.empty()) schema["required"] = std::move(needed);
  return schema;
}

Json example_of(const RequestDescription& request) {
  Json example = Json::object();
  for (const Member& member : request.members) {
    if (!member.spec.example_value.is_null()) example[member.name] = member.spec.example_value;
  }
  return example;
}

ProblemCollector faults_in(const RequestDescription& request, const Json& body) {
  ProblemCollector problems;
  const std::vector<std::string> known = request.names();
  if (!body.is_object()) {
    problems.add(
        Problem{.code = "type-mismatch", .detail = "The body must be an object with " + quoted_list(known) + "."});
    return problems;
  }
  for (const auto& [name, value] : body.items()) {
    if (request.find(name) != nullptr) continue;
    problems.add([&, &unknown = name] {
      const std::string shown = text_excerpt(unknown);
      return Problem{.code = "unknown-member",
                     .detail = "There is no member '" + shown + "'" + did_you_mean(shown, known),
                     .pointer = "/" + pointer_token(shown),
                     .in_request = true};
    });
  }
  for (const Member& member : request.members) {
    const auto given = body.find(member.name);
    if (given == body.end()) {
      if (!member.spec.is_required) continue;
      problems.add(Problem{.code = "required-input-missing",
                           .detail = "The body needs a member '" + member.name + "'.",
                           .pointer = "/" + pointer_token(member.name),
                           .in_request = true});
    } else if (auto fault = fault_in(member, *given)) {
      problems.add(*std::move(fault));
    }
  }
  return problems;
}

}  // namespace dini
