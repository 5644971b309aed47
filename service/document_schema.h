#pragma once

#include "geometry/json.h"

namespace dini {

/// The JSON Schema (2020-12) of graph documents of format 1, with every node type of `catalogue`: what an editor offers
/// and underlines while a document is written by hand. A document without problems is valid by it. What no schema can
/// say is left to `validate`: that links lead somewhere, types and axes of wires, cycles, formulas, names of files,
/// bounds that a document sets itself, and limits.
Json document_schema(const Json& catalogue);

}  // namespace dini
