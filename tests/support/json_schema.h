#pragma once

#include <string>
#include <vector>

#include "graph/problem.h"

namespace dini::support {

/// How a value departs from a JSON Schema; empty when it does not. Only the keywords that our descriptions use are
/// known, any other one is a departure too. `document` holds what "$ref" refers to. Stricter than the standard in one
/// thing: an object with `properties` has no others unless `additionalProperties` allows them, so that nothing comes
/// that nobody described.
std::vector<std::string> departures(const Json& value, const Json& schema, const Json& document,
                                    const std::string& place = "");

}  // namespace dini::support
