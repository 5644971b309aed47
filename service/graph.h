#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "geometry/json.h"
#include "graph/digest.h"

namespace dini {

/// A graph document as it is handed around: read once, immutable, shared. Each engine has its own kind.
class Graph {
 public:
  virtual ~Graph() = default;

  Digest hash{};         ///< as `graph_hash` of its document
  std::size_t held = 0;  ///< memory, about
};

using SharedGraph = std::shared_ptr<const Graph>;

/// Whether a graph can be kept under that name: [A-Za-z][A-Za-z0-9_-]{0,63}, as ids of nodes.
bool is_graph_id(std::string_view text);

/// Whether a node can be called that: an id, or ids joined by "/" for a node within groups.
bool is_node_id(std::string_view text);

/// SHA-256 of the canonical form (RFC 8785) of a document without `$schema`, `meta` and `ui`, which never influence
/// anything, but for the `unit` in `meta`.
Digest graph_hash(const Json& document);

/// These three, where a document has them: what a file that carries the document has besides the graph.
Json notes_of(const Json& document);

}  // namespace dini
