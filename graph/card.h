#pragma once

#include "graph/registry.h"

namespace dini {

/// The card of a node type as JSON: what the catalogue, the editor's form and the generated documentation are made of.
Json card(const NodeType& type);

/// The wire types as JSON.
Json wire_type_cards();

}  // namespace dini
