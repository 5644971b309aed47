#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <set>
#include <string>

#include "graph/problem.h"

namespace dini::cli {

/// Where the settings of a command come from: a flag, else the environment (`DINI_` and the name), else one file in
/// TOML, else the default. A setting is an option of the command; in the file it is called as its flag is, with
/// underscores, and must be written as what it is: a number, a text, or a list of texts.
class Configuration {
 public:
  /// Adds `--config` and `--print-config`. The command must live as long as this.
  explicit Configuration(CLI::App& command);

  /// Says what an option is when nobody sets it, for those that are something then.
  void usual(const CLI::Option* option, std::string text) { usual_.emplace(option, std::move(text)); }
  /// An option whose value is never shown.
  void hide(const CLI::Option* option) { hidden_.insert(option); }

  /// Gives every option that was added so far its environment variable, and every list a separator in it: a comma.
  void name_variables();

  /// Reads the file, if there is one, for what neither a flag nor the environment has set. All of it must be well, also
  /// what is not needed. Problems: `usage`, which names file, line and setting, and `io`.
  Problems read();

  /// Whether the settings are to be printed, instead of being used.
  bool is_to_be_printed() const { return print_; }
  /// Every setting as a file that says the same, with what it is and where its value came from. What is hidden is left
  /// out, and said to be.
  std::string text() const;

 private:
  CLI::App& command_;
  const CLI::Option* file_option_ = nullptr;
  std::string file_;
  bool print_ = false;
  std::map<const CLI::Option*, std::string> usual_;
  std::set<const CLI::Option*> hidden_;
  std::set<const CLI::Option*> from_file_;
};

}  // namespace dini::cli
