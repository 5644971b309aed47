#pragma once

#include "graph/problem.h"

namespace dini {

/// What differs between two documents as a reader of graphs sees it: nodes and parameters that were added, removed and
/// changed, of a changed node its type, its inputs and its bypass, of a changed parameter its members, each `from` what
/// it was `to` what it is; and `groups` likewise, of a changed group its `nodes` as those of a document and its other
/// members as those of a parameter, where either document has groups. What is the same when it is left out is no
/// difference.
Json graph_difference(const Json& before, const Json& after);

}  // namespace dini
