#pragma once

#include <string>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// One way to evaluate a graph.
struct TestCase {
  std::string name;  ///< empty for the one case of a graph without a file of cases
  Json parameters = Json::object();
  std::string fails = {};  ///< code of the problem that it must end with; empty when it must succeed
};

/// Reads `{"cases": {"NAME": {"parameters": {...}, "fails": "CODE", "description": "..."}}}`; all members of a case may
/// be left out. Names are letters, digits, space, `_`, `-` and `.`, for files are called after them. Problems are those
/// of `parse_json`, and `bad-cases` with pointers.
Result<std::vector<TestCase>> read_cases(const std::string& text, const Limits& limits);

}  // namespace dini::cli
