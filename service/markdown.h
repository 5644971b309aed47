#pragma once

#include <string>

#include "graph/problem.h"
#include "service/example_markdown.h"

namespace dini {

/// The catalogue of `GET /v1/nodes` as a page to read: a chapter per family, and per node its doc, source, and tables
/// of inputs and outputs, with the example where there is one. `docs/nodes.md` is this text; a test holds the two
/// equal.
std::string nodes_markdown(const Json& catalogue, const NodeExamples& examples);

}  // namespace dini
