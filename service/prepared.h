#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/plan.h"

namespace dini {

/// Outputs of one node that can be drawn, in their order; a node without any only shows that it is there.
struct Preview {
  std::size_t node = 0;  ///< by index into the plan
  std::vector<std::size_t> outputs;
};

/// A check that cannot run, and why.
struct BrokenCheck {
  std::string node;
  std::string reason;
};

/// A checked request: everything that is known before anything is computed.
class Prepared : public std::enable_shared_from_this<Prepared> {
 public:
  Document document;
  Plan plan;
  std::optional<std::size_t> output;       ///< the export node, by index into the plan
  std::vector<std::size_t> targets;        ///< the export node and everything that always runs with it
  std::vector<Preview> previews;           ///< by the ids of their nodes
  Digest preview_digest{};                 ///< of everything that the drawn previews depend on
  Problems elsewhere;                      ///< of nodes that are not needed
  std::vector<BrokenCheck> broken_checks;  ///< that should have run with the output
  Json extras;                             ///< what is written into the file's asset.extras
  std::string entity_tag;                  ///< quoted
  double milliseconds = 0;                 ///< that preparing took
};

inline double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace dini
