#include "server/query.h"

#include <algorithm>

#include "graph/nearest.h"
#include "server/addresses.h"
#include "server/text.h"

namespace dini::server {
namespace {

Problem unknown_name(const std::string& shown, const std::string& name, const std::vector<std::string>& names) {
  std::string takes = "this address takes none";
  if (!names.empty()) {
    takes.clear();
    for (const std::string& known : names) takes += (takes.empty() ? "this address takes '" : "', '") + known;
    takes += "'" + did_you_mean(name, names);
  }
  return {.code = "unknown-member", .detail = "There is no '" + shown + "' in a query here: " + takes};
}

}  // namespace

std::vector<std::string> query_names(const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) {
    if (parameter.place == Parameter::Place::query) names.push_back(parameter.name);
  }
  return names;
}

Result<std::map<std::string, std::string>> read_query(const Request& request, const std::vector<std::string>& names) {
  std::map<std::string, std::string> values;
  for (auto& [name, value] : decoded_query(request.query)) {
    const std::string shown = escape_controls(name, 80);
    if (std::ranges::find(names, name) == names.end()) return unknown_name(shown, name, names);
    if (!values.emplace(name, std::move(value)).second) {
      return Problem{.code = "unknown-member", .detail = "The query has '" + shown + "' twice."};
    }
  }
  return values;
}

}  // namespace dini::server
