#pragma once

// The commands of the program as they are declared: what pages, completions and the manual are written from.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace dini::cli {

/// One option, or what a command takes without a name.
struct DescribedOption {
  std::vector<std::string> flags = {};  ///< "-o", "--out"; empty for what has no name
  std::string value = {};               ///< what it takes, in one word of capitals; empty for a flag
  std::string doc = {};
  std::vector<std::string> choices = {};  ///< the words that it takes, where there are only so many
  std::string variable = {};              ///< of the environment, that stands for it; may be empty
  bool is_required = false;
};

struct DescribedCommand {
  std::string name;  ///< with those that it belongs to: "store list"
  std::string doc;
  std::string examples;  ///< lines of a shell
  std::vector<DescribedOption> options;
  std::vector<DescribedCommand> commands;  ///< deeper ones
};

/// Every command of the program, in the order of their declaration.
std::vector<DescribedCommand> described_commands(const CLI::App& program);

}  // namespace dini::cli
