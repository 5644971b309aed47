#pragma once

#include <string>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// Everything from a file, or from a device, which may have no end, or from standard input for `-`. Problems: `io`, and
/// `limit-exceeded` beyond `most` bytes.
Result<std::string> read_input(const std::string& path, std::size_t most);

/// A `usage` problem when standard input is to be both the graph and a file that it names, or several of these.
Problems read_twice(const std::string& graph, std::vector<std::string> files);

/// Values for parameters from `name=value` words: JSON if the value parses as such, else text. The problem has code
/// `usage`, also for a name given twice.
Result<Json> read_settings(const std::vector<std::string>& words, const Limits& limits);

}  // namespace dini::cli
