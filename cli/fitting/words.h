#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// The options `--vary` and `--target` of `dini fit`.
class FitWords {
 public:
  void add_options(CLI::App& command);

  /// `reach,height=0.2:3` as requests have it: by parameter its bounds, or an empty list for its own. The problem has
  /// code `usage`.
  Result<Json> vary() const;

  /// `mass.volume=0.8` and `tip=[0,0,1]`: by place the numbers. The problem has code `usage`.
  Result<Json> targets(const Limits& limits) const;

 private:
  std::vector<std::string> vary_, targets_;
};

}  // namespace dini::cli
