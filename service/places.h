#pragma once

// Places in a graph as requests write them, and what is said about those that are not there. `pointer` is that of the
// request's member.

#include <string>

#include "graph/document.h"
#include "graph/names.h"
#include "graph/node_type.h"

namespace dini {

/// No node is called so, or it is an instance of a group that has no such output.
Problem unknown_node(const Document& document, const PlaceName& place, const std::string& pointer);
Problem unknown_output(const NodeType& type, const std::string& node, const std::string& output,
                       const std::string& pointer);

/// A bypassed node passes on one value, whatever outputs its type has.
Problem bypassed_output(const std::string& node, const std::string& output, const std::string& pointer);

}  // namespace dini
