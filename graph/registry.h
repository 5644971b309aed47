#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "graph/node_type.h"

namespace dini {

/// The node types there are, by id. Filled once at start-up, then only read.
class Registry {
 public:
  /// Adds a node type. Throws std::logic_error on an incomplete or contradictory card: that is a bug in the catalogue
  /// and must stop the program at start-up.
  void add(NodeType type);

  const NodeType* find(std::string_view id) const;
  const std::map<std::string, NodeType, std::less<>>& types() const { return types_; }

 private:
  std::map<std::string, NodeType, std::less<>> types_;
};

}  // namespace dini
