#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/source_text.h"
#include "graph/problem.h"

namespace dini::cli {

/// Text from a graph made harmless for a terminal: control characters become \xNN, UTF-8 text stays.
std::string printable(std::string_view text);

/// `file:line:column: error: node.port: what is wrong [code]`, as far as that is known, without the end of the line.
std::string problem_line(const Problem& problem, const SourceText* source = nullptr);

/// The warnings of a report, likewise.
std::vector<std::string> warning_lines(const Json& report, const SourceText& source,
                                       const std::string& kind = "warning");

/// How a command tells on standard error what is beside its answer. Colors come on a terminal only, and not where the
/// environment has NO_COLOR; an option says otherwise.
class Console {
 public:
  /// Adds `--color`.
  void add_options(CLI::App& command);
  /// Adds `--json`. What keeps a command from its answer is then the answer, `{"succeeded": false, "errors": [...]}`;
  /// but what is wrong with the words of the call stays a line.
  void add_json_option(CLI::App& command, const std::string& description);

  /// Whether JSON is asked for.
  bool json() const { return json_; }

  /// One line each: `file:line:column: error: node.port: what is wrong [code]`, as far as that is known.
  void problems(const Problems& problems, const SourceText* source = nullptr) const;
  /// The warnings of a report, likewise.
  void warnings(const Json& report, const SourceText& source) const;
  /// `problems`, or with `--json` all of them as the answer, and the exit code back: the last line of a command that
  /// failed.
  int fail(const Problems& problems, int code, const SourceText* source = nullptr) const;

  bool colors_errors() const;
  bool colors_output() const;

 private:
  bool colors(int descriptor) const;

  std::string color_ = "auto";
  bool json_ = false;
};

/// The same with the usual colors.
int fail(const Problems& problems, int code, const SourceText* source = nullptr);

}  // namespace dini::cli
