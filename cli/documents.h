#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// Everything from a file, or from standard input for `-`. The problem has code `io`.
Result<std::string> read_input(const std::string& path);

/// Writes a whole file, or to standard output for `-`. A file appears complete or not at all.
Problems write_output(const std::string& path, std::string_view bytes);

/// A graph document from a file or `-`.
Result<Json> read_graph(const std::string& path, const Limits& limits);

/// Values for parameters from `name=value` words: JSON if the value parses as such, else text. The problem has code
/// `usage`.
Result<Json> read_settings(const std::vector<std::string>& words, const Limits& limits);

}  // namespace dini::cli
