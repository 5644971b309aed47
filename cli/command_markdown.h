#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace dini::cli {

/// The page about the command line, docs/cli.md: every command with its options, as they are declared.
std::string commands_markdown(const CLI::App& program);

}  // namespace dini::cli
