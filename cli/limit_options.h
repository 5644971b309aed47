#pragma once

#include <CLI/CLI.hpp>

#include "server/settings.h"
#include "service/limit_table.h"

namespace dini::cli {

/// An option for every limit, which its environment variable sets too. Both owners must live as long as the command.
void add_limit_options(CLI::App& command, Limits& limits, server::Settings& settings);

}  // namespace dini::cli
