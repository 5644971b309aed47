#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// Everything from a file, or from a device, which may have no end. Problems: `io`, and `limit-exceeded` beyond `most`
/// bytes.
Result<std::string> read_file(const std::string& path, std::size_t most);

/// Everything from a file, or from standard input for `-`. Problems: `io`, and `limit-exceeded` beyond 64 MiB.
Result<std::string> read_input(const std::string& path);

/// Writes a whole file, or to standard output for `-`. A file appears complete or not at all, also behind a symbolic
/// link; what is no file (a device, a pipe) is written to.
Problems write_output(const std::string& path, std::string_view bytes);

/// Takes away the file of an earlier run, if there is one; what is no file stays.
void remove_file(const std::string& path);

/// A path that a command writes, and the option that gives it; no path when the option is not given.
struct OutputPath {
  std::string option;
  std::optional<std::string> path;
};

/// What can be told about the paths of a command before its work is done: folders that are not there (`io`), and an
/// empty path, one path written twice, or read and written (`usage`).
Problems unwritable(const std::vector<OutputPath>& outputs, const std::vector<std::string>& inputs);

/// The graph document in a file or `-`, as JSON.
Result<Json> read_graph(const std::string& path, const Limits& limits);

/// Values for parameters from `name=value` words: JSON if the value parses as such, else text. The problem has code
/// `usage`, also for a name given twice.
Result<Json> read_settings(const std::vector<std::string>& words, const Limits& limits);

}  // namespace dini::cli
