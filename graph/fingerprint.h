#pragma once

#include "graph/plan.h"

namespace dini {

/// The content key of a node: its type and version, its literals, and the fingerprints of what is wired to it. Ids,
/// names of axes and everything under `ui` do not count; how axes pair up does.
Digest fingerprint(const PlannedNode& node, const Plan& plan);

}  // namespace dini
