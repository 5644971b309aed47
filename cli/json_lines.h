#pragma once

#include <memory>
#include <spdlog/formatter.h>

namespace dini::cli {

/// Makes every line of the log a JSON object: `time` (UTC), `level` and `message`, or the members of a request.
std::unique_ptr<spdlog::formatter> json_lines();

}  // namespace dini::cli
