#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dini {

/// The beginning of a text, cut between UTF-8 characters; of one from outside, what a problem repeats of it.
std::string text_excerpt(std::string_view text, std::size_t most_bytes = 64);

/// 'a', 'b', 'c'
std::string quoted_list(const std::vector<std::string>& names);

}  // namespace dini
