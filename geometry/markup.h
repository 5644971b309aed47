#pragma once

#include <string>
#include <string_view>

namespace dini {

/// Text that XML and HTML read as itself, between tags and in attributes. Control characters stay as they are.
std::string escaped_markup(std::string_view text);

}  // namespace dini
