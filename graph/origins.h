#pragma once

#include "graph/document.h"
#include "graph/plan.h"

namespace dini {

/// Finds where the wires of nodes that name parts come from: through bypassed nodes, and through nodes that only pass
/// on what they are given.
void find_origins(Plan& plan, const Document& document);

}  // namespace dini
