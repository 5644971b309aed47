#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dini {

/// Pairs of indices as a graph writes them: "0-1 1-2 2-0", with spaces or commas between.
using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The pairs of a text; nothing when it is not of that form.
std::optional<Links> read_links(const std::string& text);

/// What is wrong with a text, in words; nothing when it can be read.
std::optional<std::string> fault_of_links(const std::string& text);

}  // namespace dini
