#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "graph/plan.h"

namespace dini {

/// A checked request: everything that is known before anything is computed.
class Prepared : public std::enable_shared_from_this<Prepared> {
 public:
  Document document;
  Plan plan;
  std::size_t output = 0;            ///< the export node, by index into the plan
  std::vector<std::size_t> targets;  ///< the export node and everything that always runs
  Json extras;                       ///< what is written into the file's asset.extras
  std::string entity_tag;            ///< quoted
  double milliseconds = 0;           ///< that preparing took
};

inline double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace dini
