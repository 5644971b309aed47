#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "service/document_graph.h"
#include "service/engine.h"

namespace dini {

/// Outputs of one node that can be drawn, in their order; a node without any only shows that it is there.
struct Preview {
  std::size_t node = 0;  ///< by index into the plan
  std::vector<std::size_t> outputs;
};

/// An output whose values are told.
struct Measure {
  std::string place;     ///< as it was asked for
  std::size_t node = 0;  ///< by index into the plan
  std::size_t output = 0;
};

/// What the engine over the catalogue knows of a checked request.
class PreparedGraph final : public Prepared {
 public:
  std::shared_ptr<const DocumentGraph> graph;  ///< whose document is one
  Plan plan;
  std::optional<std::size_t> export_node;  ///< by index into the plan
  std::vector<std::size_t> targets;        ///< the export node, everything that always runs with it, what is measured
  std::vector<Preview> previews;           ///< by the ids of their nodes
  std::vector<Measure> measures;           ///< as they were asked for
  std::vector<std::size_t> part_nodes;     ///< that make the parts of the model; none unless those are to be told
  Digest fingerprint{};                    ///< of what the model depends on, whatever file it is written into
  Digest parts_digest{};                   ///< of everything that the told parts depend on
  Digest preview_digest{};                 ///< of everything that the drawn previews depend on
  Problems elsewhere;                      ///< of nodes that are not needed
  double milliseconds = 0;                 ///< that preparing took
};

inline double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace dini
