#include "service/outputs.h"

#include <algorithm>

#include "graph/groups.h"
#include "graph/literal.h"
#include "graph/names.h"
#include "graph/nearest.h"

namespace dini {

namespace {

Problem unknown_export(std::string detail) {
  return {.code = "unknown-output", .detail = std::move(detail), .pointer = "/output", .in_request = true};
}

}  // namespace

Exports exports_of(const Registry& registry, const Document& document) {
  Exports exports;
  for (const auto& [id, node] : document.nodes) {
    const NodeType* type = registry.find(node.type);
    if (type == nullptr) {
      exports.unknown.push_back(id);
    } else if (!node.bypass && !type->outputs.empty() && type->outputs.front().types.front() == WireType::asset) {
      exports.known.push_back(id);
    }
  }
  return exports;
}

Result<std::string> find_output(const Registry& registry, const Document& document, const std::string& named) {
  const auto [exports, unknown] = exports_of(registry, document);
  std::string list;
  for (const std::string& id : exports) list += (list.empty() ? "" : ", ") + id;
  if (named.empty()) {
    if (exports.size() == 1) return exports.front();
    if (exports.empty() && !unknown.empty()) return unknown.front();
    return unknown_export(exports.empty() ? "the graph has no export node"
                                          : "the graph has several outputs, choose one of " + list);
  }
  const auto is_export = [&](const std::string& id) {
    return std::ranges::find(exports, id) != exports.end() || std::ranges::find(unknown, id) != unknown.end();
  };
  if (document.instances.contains(place_name(named).node)) {
    for (const std::string& place : places_behind(document, named)) {
      if (std::string id = place_name(place).node; is_export(id)) return id;
    }
  } else if (is_export(named)) {
    return named;
  }
  return unknown_export(excerpt(named) + " is no export node of the graph" + did_you_mean(named, exports) +
                        (exports.empty() ? "" : "; there is " + list));
}

}  // namespace dini
