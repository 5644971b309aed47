#include <algorithm>
#include <charconv>

#include "graph/groups.h"
#include "graph/names.h"

namespace dini {

namespace {

/// The first token of a pointer, as it was before it was made fit for one; the rest is left in `pointer`.
std::string take_token(std::string_view& pointer) {
  pointer.remove_prefix(1);
  const std::size_t end = std::min(pointer.find('/'), pointer.size());
  std::string token;
  for (std::size_t i = 0; i < end; ++i) {
    const bool escaped = pointer[i] == '~' && i + 1 < end;
    if (escaped) ++i;
    token += !escaped ? pointer[i] : pointer[i] == '1' ? '/' : '~';
  }
  pointer.remove_prefix(end);
  return token;
}

/// Where a pointer into an expanded document leads in the one that was written.
std::string written_place(const std::string& pointer, const Document& document) {
  std::string_view rest = pointer;
  if (!rest.starts_with("/nodes/")) return pointer;
  take_token(rest);
  const auto place = document.places.find(take_token(rest));
  if (place == document.places.end()) return pointer;
  const std::string in_node = place->second.pointer + std::string(rest);
  if (!rest.starts_with("/inputs/")) return in_node;
  take_token(rest);
  const auto given = place->second.inputs.find(take_token(rest));
  if (given == place->second.inputs.end() || given->second.empty()) return in_node;
  const std::vector<std::string>& items = given->second;
  std::string_view after = rest;
  std::size_t item = 0;
  if (after.starts_with('/')) {
    const std::string token = take_token(after);
    const auto read = std::from_chars(token.data(), token.data() + token.size(), item);
    const bool is_number = read.ec == std::errc() && read.ptr == token.data() + token.size();
    if (is_number && item < items.size()) return items[item] + std::string(after);
  }
  return items.size() == 1 ? items.front() + std::string(rest) : in_node;
}

/// A patch for the document that was written; null where it would do something else there.
Json written_fix(const Json& fix, const Document& document) {
  if (fix.is_null()) return fix;
  Json patch = fix;
  for (Json& operation : patch) {
    const std::string path = operation.at("path").get<std::string>();
    const std::string place = written_place(path, document);
    if (place == path) continue;
    const bool writes_literal =
        operation.at("op") == "replace" && !path.ends_with("/from") && !operation.at("value").is_object();
    if (!writes_literal) return nullptr;
    operation["path"] = place;
  }
  return patch;
}

}  // namespace

Problems placed(Problems problems, const Document& document) {
  if (document.places.empty()) return problems;
  for (Problem& problem : problems) {
    if (problem.in_request || !problem.pointer) continue;
    problem.pointer = written_place(*problem.pointer, document);
    problem.fix = written_fix(problem.fix, document);
  }
  return problems;
}

std::vector<std::string> places_behind(const Document& document, const std::string& place) {
  const auto& [id, output_name, has_output] = place_name(place);
  const auto instance = document.instances.find(id);
  if (instance == document.instances.end()) return {place};
  std::vector<std::string> places;
  for (const GroupOutput& output : instance->second) {
    if (has_output && output.name != output_name) continue;
    places.push_back(output.from.node + (output.from.output.empty() ? "" : "." + output.from.output));
  }
  return places.empty() ? std::vector{place} : places;
}

}  // namespace dini
