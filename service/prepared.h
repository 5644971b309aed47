#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "service/engine.h"

namespace dini {

/// Outputs of one node that can be drawn, in their order; a node without any only shows that it is there.
struct Preview {
  std::size_t node = 0;  ///< by index into the plan
  std::vector<std::size_t> outputs;
};

/// What the engine over the catalogue knows of a checked request.
class PreparedGraph final : public Prepared {
 public:
  Document document;
  Plan plan;
  std::optional<std::size_t> export_node;  ///< by index into the plan
  std::vector<std::size_t> targets;        ///< the export node and everything that always runs with it
  std::vector<Preview> previews;           ///< by the ids of their nodes
  Digest fingerprint{};                    ///< of what the model depends on, whatever file it is written into
  Digest preview_digest{};                 ///< of everything that the drawn previews depend on
  Problems elsewhere;                      ///< of nodes that are not needed
  double milliseconds = 0;                 ///< that preparing took
};

inline double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace dini
