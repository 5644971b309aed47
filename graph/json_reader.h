#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graph/limits.h"
#include "graph/problem.h"

namespace dini {

/// Reads JSON from outside, strictly: no duplicate keys, no NUL, no control characters in names, nothing after the end,
/// depth, number of values and string lengths within the limits. A byte order mark before it is passed over, and
/// numbers that are whole become integers whatever their spelling. The problem has code `not-json` or `limit-exceeded`
/// and says where.
Result<Json> parse_json(std::string_view text, const Limits& limits);

/// The byte that keeps a text from being read, by the rules of `parse_json`: where the fault begins, or the name or
/// text that is refused. Nothing when the text is read.
std::optional<std::size_t> offset_of_fault(std::string_view text, const Limits& limits);

/// `token` made fit to stand in a JSON pointer: ~ becomes ~0, / becomes ~1.
std::string pointer_token(std::string_view token);

}  // namespace dini
