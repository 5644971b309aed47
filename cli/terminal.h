#pragma once

#include <string>
#include <string_view>

#include "graph/problem.h"

namespace dini::cli {

/// Text from a graph made harmless for a terminal: control characters become \xNN, UTF-8 text stays.
std::string printable(std::string_view text);

/// `error[out-of-range] k.count: 0 is below 1`, one line on stderr each.
void print_problems(const Problems& problems);

/// Prints problems and gives the exit code back: the last line of a command that failed.
int fail(const Problems& problems, int code);

/// The line of one problem given as JSON, as the engine's `validate` lists them.
std::string problem_line(const Json& problem);

}  // namespace dini::cli
