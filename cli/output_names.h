#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/problem.h"

namespace dini::cli {

/// What `-o` was given: one pattern for all outputs, or a file for each of some.
struct OutputNames {
  std::string pattern;                       ///< empty when there is none
  std::map<std::string, std::string> named;  ///< patterns by output

  bool empty() const { return pattern.empty() && named.empty(); }
  /// Whether a name differs from output to output, so that all of them can be written.
  bool tells_outputs() const;
};

/// Reads words as `NAME=PATTERN`, where NAME could be that of a node, or as the one `PATTERN`. A pattern may hold
/// `{graph}` (the name of the document without folder and ending), `{output}` and what else is in `known`. Problems:
/// `usage`.
Result<OutputNames> read_output_names(const std::vector<std::string>& words, const std::vector<std::string>& known);

/// A pattern with values for what it names in braces.
std::string filled(const std::string& pattern, const std::map<std::string, std::string>& values);

/// Whether a pattern has `{name}`.
bool names(const std::string& pattern, const std::string& name);

/// The `{graph}` of a path: `ring` for `parts/ring.json`, `graph` for standard input.
std::string graph_name(const std::string& path);

}  // namespace dini::cli
