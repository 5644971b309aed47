#pragma once

#include "algebra/elements.h"
#include "geometry/json.h"

namespace dini::support {

/// Three numbers as JSON.
inline Vector triple(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

}  // namespace dini::support
