#pragma once

// Graphs in which one node has much to do, found from its declaration alone.

#include "tests/nodes/node_inputs.h"

namespace dini::support {

/// Every way in which a function can be given about `size` things: over an axis that it is lifted over, along the axes
/// that it consumes, in a mesh, or by its counts. The nodes of one document each; the subject is the node "subject".
std::vector<Json> large_graphs(const Subject& subject, std::size_t size);

}  // namespace dini::support
