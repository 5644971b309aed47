#pragma once

#include <string>
#include <vector>

#include "graph/document.h"

namespace dini {

/// The nodes of a document so that each stands after those it links to; ties by id. Links to nodes that do not exist
/// are ignored. Nodes on a cycle, and nodes behind one, are left out; `cycle` then names one cycle in order.
struct Order {
  std::vector<std::string> ids;
  std::vector<std::string> cycle;
};

Order evaluation_order(const Document& document);

/// The nodes that `node` links to, each once, in order of its ports.
std::vector<std::string> sources_of(const NodeEntry& node);

}  // namespace dini
