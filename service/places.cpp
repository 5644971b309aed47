#include "service/places.h"

#include "graph/literal.h"
#include "graph/nearest.h"

namespace dini {

Problem unknown_node(const Document& document, const std::string& node, const std::string& pointer) {
  std::vector<std::string> known;
  for (const auto& [id, entry] : document.nodes) known.push_back(id);
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
  std::vector<std::string> known;
  for (const OutputPort& port : type.outputs) known.push_back(port.name);
  return {"unknown-port",
          type.title + " has no output " + excerpt(output) + did_you_mean(output, known),
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
