#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/source_text.h"

namespace dini::cli {

/// A file to make of a graph.
struct EvalTarget {
  std::string output = {};  ///< the export node; empty for the only one, or where a preview is drawn instead
  std::optional<std::string> path = {};  ///< nothing when the model is only described
  const FileFormat* format = nullptr;
};

/// A graph that was given, with what to make of it, at least one target.
struct EvalGraph {
  std::string path;
  std::optional<SourceText> source = {};
  std::optional<Json> document = {};
  Problems problems = {};  ///< why it could not be read
  int code = 0;            ///< the exit code of these
  std::vector<EvalTarget> targets = {};
};

/// What the options say about files.
struct EvalWishes {
  std::vector<std::string> graphs;
  std::vector<std::string> outputs;  ///< the words of -o
  std::string output;                ///< --output
  std::string format;                ///< --format
  bool previews = false;
};

/// Reads the graphs and finds what is to be made of each. A graph that cannot be read is no problem here, it says so
/// itself. Problems: `usage`, for names of files that do not go with what was asked for.
Result<std::vector<EvalGraph>> eval_graphs(const Engine& engine, const EvalWishes& wishes);

}  // namespace dini::cli
