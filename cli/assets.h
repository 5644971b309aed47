#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// The files that graphs may name: those of the examples beside the program, as in `dini serve`, and those of the
/// option `--asset name=file`.
class Assets {
 public:
  void add_option(CLI::App& command);

  /// Reads the files and gives them to the engine, those of the examples only where one of these documents names a
  /// file, for reading them is half of the work on a small graph. Problems: `usage` for words that are not name=file
  /// and for a name given twice, `io`, what is wrong with a file, and those of `Engine::compute` when `cancel` stops
  /// the reading.
  Problems give_to(const Engine& engine, const std::vector<const Json*>& documents, const Cancel& cancel) const;

  /// The files named by the option, which must not be written over.
  std::vector<std::string> paths() const;

 private:
  std::vector<std::string> words_;
};

}  // namespace dini::cli
