#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dini {

/// At most 64 bytes of a text from outside, cut between UTF-8 characters: what a problem repeats of it.
std::string short_excerpt(std::string_view text);

/// 'a', 'b', 'c'
std::string quoted_list(const std::vector<std::string>& names);

}  // namespace dini
