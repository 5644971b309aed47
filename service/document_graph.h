#pragma once

#include "geometry/length_unit.h"
#include "graph/document.h"
#include "graph/limits.h"
#include "service/graph.h"

namespace dini {

/// What the engine over the catalogue knows of a graph: the document without its notes and its groups, or what is wrong
/// with it.
class DocumentGraph final : public Graph {
 public:
  DocumentGraph(const Json& json, const Digest& known_hash, const Limits& limits, const Registry& registry);

  const std::optional<Document> with_groups;  ///< as it was written, where it has any
  const Result<Document> document;
  const std::optional<LengthUnit> unit;  ///< of its coordinates, if its notes say one

 private:
  DocumentGraph(Result<Document> read, std::optional<LengthUnit> unit, const Digest& known_hash, const Limits& limits,
                const Registry& registry);
};

}  // namespace dini
