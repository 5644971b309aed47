#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/assets.h"
#include "cli/program.h"
#include "cli/source_text.h"
#include "cli/terminal.h"

namespace dini::cli {

/// A graph that was read into an engine, with the values for its parameters.
struct GivenGraph {
  SourceText source;
  Json document;
  Json parameters;
  std::unique_ptr<Engine> engine;
  SharedGraph graph;
};

/// What every command takes that looks at one graph: the document, values for its parameters, the files that it names.
class GraphArguments {
 public:
  void add_options(CLI::App& command);

  /// `Console::add_json_option`.
  void add_json_option(CLI::App& command, const std::string& description) {
    console_.add_json_option(command, description);
  }

  const std::string& path() const { return path_; }
  const Console& console() const { return console_; }

  /// Reads all of it. What is wrong is told on standard error, and to `failed` if it is given; the exit code for that
  /// is the error.
  Expected<GivenGraph, int> load(
      const EngineMaker& make_engine,
      const std::function<void(const Problems& problems, const SourceText* source)>& failed = {}) const;

 private:
  std::string path_;
  std::vector<std::string> settings_;
  Assets assets_;
  Console console_;
};

}  // namespace dini::cli
