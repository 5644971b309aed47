#pragma once

#include "server/application.h"

namespace dini::server {

/// The JSON body of a request about a graph.
struct GraphBody {
  Json json;
  bool names_graph = false;  ///< it had the name of a kept graph, whose document stands there now
};

/// Reads the body of a request; `"graph": "chair"` is the current version of a kept graph, `"chair@3"` one of all.
/// Beside those of the JSON reader, the problems are `unknown-graph` and those of the store.
Result<GraphBody> read_graph_body(const Context& context);

}  // namespace dini::server
