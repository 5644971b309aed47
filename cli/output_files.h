#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/problem.h"

namespace dini::cli {

/// What a command writes, by which it knows its own files of earlier runs: nothing else is ever replaced.
enum class OutputKind {
  any,     ///< of no certain kind
  model,   ///< known by the ending of its format; never a graph document
  report,  ///< JSON with `succeeded`
  log,     ///< JSON with `runs`
  xml,
  page,   ///< Markdown
  table,  ///< CSV
};

/// A path that a command writes, and the option that gives it; no path when the option is not given.
struct OutputPath {
  std::string option;
  std::optional<std::string> path;
  OutputKind kind = OutputKind::any;
  std::string extension = {};  ///< that a model has, with its period
};

/// What can be told about the paths of a command before its work is done: folders that are not there (`io`); and an
/// empty path, one path written twice, or read and written, or a file of another kind in the way (`usage`).
Problems unwritable(const std::vector<OutputPath>& outputs, const std::vector<std::string>& inputs);

/// Makes the folders that these files need. Problems: `io`.
Problems make_folders(const std::vector<OutputPath>& outputs);

/// Writes a whole file, or to standard output for `-`. A file appears complete or not at all, also behind a symbolic
/// link; what is no file (a device, a pipe) is written to. Problems: `io`.
Problems write_output(const std::string& path, std::string_view bytes);

/// Takes away the file of an earlier run, if there is one; what is no file stays.
void remove_file(const std::string& path);

/// Whether JSON looks like a graph document, right or wrong.
bool looks_like_graph(const Json& json);

}  // namespace dini::cli
