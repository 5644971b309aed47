#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "cli/source_text.h"
#include "graph/problem.h"

namespace dini::cli {

/// Text from a graph made harmless for a terminal: control characters become \xNN, UTF-8 text stays.
std::string printable(std::string_view text);

/// `file:line:column: error: node.port: what is wrong [code]`, as far as that is known, without the end of the line.
std::string problem_line(const Problem& problem, const SourceText* source = nullptr);

/// How a command tells on standard error what is beside its answer. Colors come on a terminal only, and not where the
/// environment has NO_COLOR; an option says otherwise.
class Console {
 public:
  /// Adds `--color`.
  void add_options(CLI::App& command);

  /// One line each: `file:line:column: error: node.port: what is wrong [code]`, as far as that is known.
  void problems(const Problems& problems, const SourceText* source = nullptr) const;
  /// The warnings of a report, likewise.
  void warnings(const Json& report, const SourceText& source) const;
  /// `problems`, and the exit code back: the last line of a command that failed.
  int fail(const Problems& problems, int code, const SourceText* source = nullptr) const;

  bool colors_errors() const;
  bool colors_output() const;

 private:
  bool colors(int descriptor) const;

  std::string color_ = "auto";
};

/// The same with the usual colors.
int fail(const Problems& problems, int code, const SourceText* source = nullptr);

}  // namespace dini::cli
