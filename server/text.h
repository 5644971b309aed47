#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dini::server {

/// Without the spaces and tabs at both ends.
std::string_view trim(std::string_view text);

/// ASCII letters in lower case; other bytes stay.
std::string to_lower(std::string_view text);

/// Equal but for the case of ASCII letters.
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The trimmed parts between separators; empty parts are left out.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The number that a text of decimal digits, and nothing else, is; nothing for any other.
std::optional<std::size_t> whole_number(std::string_view text);

/// Text from outside made safe for a terminal and a log line: controls and bytes past ASCII become \xNN, and at most
/// `limit` bytes are kept.
std::string escape_controls(std::string_view text, std::size_t limit = 200);

/// Milliseconds since 1970 as RFC 3339, in UTC.
std::string time_text(std::int64_t milliseconds);

/// FNV-1a, as 16 hexadecimal digits: names the content of files that never change while the server runs.
std::string content_hash(std::string_view bytes);

}  // namespace dini::server
