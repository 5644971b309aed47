#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dini {

/// The known name nearest to `given` by edit distance; empty when none is near enough to be meant.
std::string nearest(std::string_view given, const std::vector<std::string>& known);

/// "; did you mean \"x\"?" or nothing: the end of an error sentence about an unknown name.
std::string did_you_mean(std::string_view given, const std::vector<std::string>& known);

}  // namespace dini
