#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/source_text.h"
#include "golden/compare.h"

namespace dini::cli {

/// How an output compares with its golden result.
enum class GoldenState {
  none,     ///< nothing is kept to compare with, and nothing has to be
  same,     ///< the same bytes
  within,   ///< the same shape
  changed,  ///< not the same
  missing,  ///< there should be a golden result
  updated,  ///< it was written just now
};

std::string_view name_of(GoldenState state);

/// One output of a case.
struct OutputResult {
  Json report = Json::object();
  GoldenState golden = GoldenState::none;
  Comparison comparison = {};
};

/// What became of one case of one graph.
struct CaseResult {
  std::string graph = {};                 ///< path
  std::string name = {};                  ///< of the case; empty for the only one
  std::optional<SourceText> source = {};  ///< of what the problems are about: the graph, or its cases
  int code = 0;                           ///< an `ExitCode`
  bool skipped = false;                   ///< not begun, after another one failed
  Problems problems = {};
  std::map<std::string, OutputResult> outputs = {};
  Json warnings = Json::array();
  double milliseconds = 0;
  std::vector<std::string> stale = {};  ///< paths of golden results that no case has

  bool passed() const { return code == 0 && !skipped; }
  /// "ring.json" or "ring.json: wide".
  std::string title() const { return graph + (name.empty() ? "" : ": " + name); }
};

/// How many of each there are.
struct Tally {
  std::size_t passed = 0, failed = 0, skipped = 0;
  double milliseconds = 0;
};
Tally tally_of(const std::vector<CaseResult>& results);

/// "7 passed, 1 failed, 1 skipped": zeros are left out, but for passed.
std::string text_of(const Tally& tally);

}  // namespace dini::cli
