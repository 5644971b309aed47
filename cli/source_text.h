#pragma once

#include <optional>
#include <string>

#include "cli/json_text.h"
#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// A graph document as it was given.
struct SourceText {
  std::string name;  ///< its path, or "standard input"
  std::string text;
};

/// What a file holds, or standard input for `-`. Problems: `io`, `limit-exceeded` beyond 64 MiB, and `not-json` for
/// text in UTF-16.
Result<SourceText> read_source(const std::string& path);

/// What it says. Problems are those of `parse_json`.
Result<Json> parse_source(const SourceText& source, const Limits& limits);

/// Where in the text a problem is; nothing when it is not in the text, as what is wrong with an option.
std::optional<TextPlace> place_of(const SourceText& source, const Problem& problem);

/// Problems as JSON, those that are in the text with `file`, `line` and `column`. Their pointers and fixes apply to
/// that text; the pointers of others say which option is meant.
Json problems_json(const Problems& problems, const SourceText* source);

/// The problems in the answer to a request whose member `graph` is the document: pointers and fixes lead into the
/// document again, or are of the request.
Problems problems_of_request(const Json& errors);

}  // namespace dini::cli
