#include "graph/node_result.h"

namespace dini {

std::size_t bytes(const NodeResult& result) {
  std::size_t total = result.warnings.size() * sizeof(result.warnings.front());
  for (const AnyColumn& column : result.columns) total += bytes(column);
  for (const auto& said : result.warnings) {
    for (const Warning& warning : said->warnings) total += sizeof warning + warning.detail.size();
  }
  return total;
}

}  // namespace dini
