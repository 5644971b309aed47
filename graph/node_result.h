#pragma once

#include <memory>
#include <vector>

#include "graph/context.h"
#include "graph/digest.h"
#include "graph/value.h"

namespace dini {

/// The warnings of one node, by what it computes: whose node that is, the plan of each request tells.
struct NodeWarnings {
  Digest fingerprint{};
  std::vector<Warning> warnings;
};

/// What a node made: one column per output, and what it and the nodes before it had to say. Complete: a node that was
/// stopped or failed has no result.
struct NodeResult {
  std::vector<AnyColumn> columns;
  /// Of this node and of everything before it, each node once; nodes that said nothing are left out. So an answer whose
  /// last node comes from the cache still has all of its warnings.
  std::vector<std::shared_ptr<const NodeWarnings>> warnings;
};

/// Memory held by a result.
std::size_t bytes(const NodeResult& result);

}  // namespace dini
