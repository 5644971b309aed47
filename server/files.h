#pragma once

#include <filesystem>
#include <string>

#include "graph/problem.h"

namespace dini::server {

/// A whole file. The problem has code `io`.
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace dini::server
