#pragma once

#include <span>
#include <string>
#include <string_view>

#include "geometry/json.h"

namespace dini {

/// JSON in the one form that it has for hashing (RFC 8785): no space, names in the order of their UTF-16 code units,
/// and numbers as ECMAScript writes them. All numbers are finite, texts are UTF-8. Members of the outermost object that
/// are called one of `left_out` are not written.
std::string canonical_json(const Json& json, std::span<const std::string_view> left_out = {});

}  // namespace dini
