#pragma once

#include <map>
#include <string>

#include "geometry/json.h"

namespace dini {

/// The graph documents of `examples/nodes/` by the node that each explains, with their members in the order written.
using NodeExamples = std::map<std::string, nlohmann::ordered_json>;

/// The picture of a node's example, and its title, description and file in words; empty when it has none.
std::string example_picture(const NodeExamples& examples, const std::string& node);

/// The nodes of a node's example as a block of JSON, one line for each; empty when it has none.
std::string example_graph(const NodeExamples& examples, const std::string& node);

}  // namespace dini
