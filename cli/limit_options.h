#pragma once

#include <CLI/CLI.hpp>

#include "cli/configuration.h"
#include "server/settings.h"
#include "service/limit_table.h"

namespace dini::cli {

/// An option for every limit of graphs, evaluations and files. The owner must live as long as the command.
void add_limit_options(CLI::App& command, Configuration& configuration, Limits& limits);

/// An option for every limit, those of the server too. Both owners must live as long as the command.
void add_limit_options(CLI::App& command, Configuration& configuration, Limits& limits, server::Settings& settings);

}  // namespace dini::cli
