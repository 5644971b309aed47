#pragma once

#include <set>
#include <string>
#include <vector>

#include "graph/document.h"

namespace dini {

/// The nodes of a document so that each stands after those it links to; ties by id. Links to nodes that do not exist
/// are ignored. Nodes on a cycle, and nodes behind one, are left out; `cycles` names the cycles, each in the order of
/// its links. Of cycles that share a node one is named.
struct Order {
  std::vector<std::string> ids;
  std::vector<std::vector<std::string>> cycles;
};

Order evaluation_order(const Document& document);

/// The nodes that `targets` depend on, those themselves included. Links to nodes that do not exist are ignored.
std::set<std::string> needed_for(const Document& document, const std::vector<std::string>& targets);

/// The nodes that `node` links to, one for each link, in order of its ports.
std::vector<const std::string*> sources_of(const NodeEntry& node);

}  // namespace dini
