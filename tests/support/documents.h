#pragma once

#include <string>

#include "graph/problem.h"

namespace dini::support {

/// A format 1 document with these nodes.
inline Json document(Json nodes) { return {{"format", 1}, {"nodes", std::move(nodes)}}; }

/// A node of a document.
inline Json make(const std::string& type, Json inputs = Json::object()) {
  return {{"type", type}, {"inputs", std::move(inputs)}};
}

/// A link to a node or to "node.output".
inline Json from(const std::string& place) { return {{"from", place}}; }

}  // namespace dini::support
