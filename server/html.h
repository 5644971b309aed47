#pragma once

#include <string>
#include <string_view>

#include "server/description_tables.h"

namespace dini::server::html {

/// Text that HTML reads as itself, with what stands between backticks as <code>.
std::string prose(std::string_view text);

/// <name attributes>content</name>
std::string element(std::string_view name, std::string_view content, std::string_view attributes = "");

/// A table that is as wide as it needs to be and scrolls when that is too wide; nothing for one without rows. Columns
/// without any text are left out.
std::string table(const Table& table);

/// A whole page. `style` is the address of its style sheet; the policy of the server allows neither scripts nor styles
/// within a page.
std::string page(std::string_view title, std::string_view style, std::string_view body);

}  // namespace dini::server::html
