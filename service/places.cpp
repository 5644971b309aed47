#include "service/places.h"

#include "graph/literal.h"
#include "graph/nearest.h"

namespace dini {

Problem unknown_node(const Document& document, const PlaceName& place, const std::string& pointer) {
  const std::string& node = place.node;
  if (const auto instance = document.instances.find(node); instance != document.instances.end()) {
    const std::string what = node + ", an instance of a group, has no output";
    return {"unknown-port",
            place.has_output
                ? what + " " + excerpt(place.output) + did_you_mean(place.output, all_names(instance->second))
                : what,
            node,
            place.output.substr(0, 64),
            pointer,
            nullptr,
            true};
  }
  std::vector<std::string> known = keys_of(document.nodes);
  for (const auto& [id, outputs] : document.instances) known.push_back(id);
  return {"unknown-node",
          "the graph has no node " + excerpt(node) + did_you_mean(node, known),
          is_path(node) ? node : "",
          "",
          pointer,
          nullptr,
          true};
}

Problem unknown_output(const NodeType& type, const std::string& node, const std::string& output,
                       const std::string& pointer) {
  return {"unknown-port",
          type.title + " has no output " + excerpt(output) + did_you_mean(output, all_names(type.outputs)),
          node,
          output.substr(0, 64),
          pointer,
          nullptr,
          true};
}

Problem bypassed_output(const std::string& node, const std::string& output, const std::string& pointer) {
  return {"unknown-port", "a bypassed node has one output only", node, output, pointer, nullptr, true};
}

}  // namespace dini
