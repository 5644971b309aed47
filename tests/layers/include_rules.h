#pragma once

// Who may include whom. All folders share the root of the project as their include directory, so linking alone does not
// stop a wrong include; these rules do. `docs/architecture.md` draws them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/layers/source_tree.h"

namespace dini::support {

/// One layer and what it may include besides itself: whole folders (`graph/`) or single headers (`graph/problem.h`).
struct LayerRule {
  std::string_view layer;
  std::vector<std::string_view> may_include;
};

/// The layers of Dini, lowest first.
std::span<const LayerRule> layer_rules();

/// What is wrong with the includes of one file of a layer, one sentence each, with the line. Wrong are: another layer
/// that the rule does not name, tests, benchmarks, and a path that does not start at the root. Libraries are not looked
/// at.
std::vector<std::string> wrong_includes(const SourceFile& file, const LayerRule& rule);

}  // namespace dini::support
