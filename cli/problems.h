#pragma once

#include <string>

#include "graph/problem.h"

namespace dini::cli {

/// What is wrong with the words that a command was given.
Problem usage_problem(std::string detail);

/// Why a file cannot be read or written, in the system's words; `error` is an `errno`.
Problem io_problem(const std::string& path, int error);

}  // namespace dini::cli
