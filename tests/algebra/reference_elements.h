#pragma once

// Elements as the reference numbers write them down.

#include "algebra/construct.h"
#include "tests/support/reference.h"
#include "tests/support/triple.h"

namespace dini::support {

inline Point point_of(const Json& json) { return to_point(triple(json)); }
inline Generator pair_of(const Json& json) { return null_pair(point_of(json["at"]), triple(json["dir"])); }

}  // namespace dini::support
