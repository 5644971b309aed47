#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/document.h"
#include "graph/port.h"

namespace dini {

/// Reads the nodes of a document and of its groups, strictly, and gathers everything that is wrong with them. Their
/// literals are read for the inputs of the registry's node types.
class NodeReader {
 public:
  /// Where nodes are. In a group they take inputs of the group and no parameters, and problems name no node, since a
  /// node of a group stands at many places; paths are ids in documents of format 2.
  enum class Where { document, document_with_paths, group };

  NodeReader(const Limits& limits, const Registry& registry) : limits_(limits), registry_(registry) {}

  /// The nodes of an object by id that stands at `pointer`.
  std::map<std::string, NodeEntry> read(const Json& json, const std::string& pointer, Where where);

  /// True when `json` is an object with no other members than `known`; adds a problem for each that is not.
  bool object(const Json& json, const std::string& pointer, const std::vector<std::string>& known,
              const std::string& node = "");
  bool identifier(const std::string& id, const std::string& pointer);
  void add(std::string code, std::string pointer, std::string detail, std::string node = "", std::string port = "");

  ProblemCollector problems;

 private:
  /// Where something is given.
  struct Place {
    const std::string& node;
    const std::string& port;
    const InputPort* card;  ///< null for an unknown one
  };

  NodeEntry read_node(const std::string& id, const Json& json, const std::string& pointer);
  InputEntry read_input(const Place& place, const Json& json, const std::string& pointer);
  InputItem read_item(const Place& place, const Json& json, const std::string& pointer);
  InputItem read_reference(const Place& place, const Json& json, const std::string& pointer);

  const Limits& limits_;
  const Registry& registry_;
  Where where_ = Where::document;
  std::size_t nodes_ = 0, links_ = 0;
};

/// "node" or "node.output".
Link read_link(const std::string& text);

}  // namespace dini
