#pragma once

// Changing the origin.

#include "algebra/elements.h"

namespace dini {

/// The same generator in coordinates whose origin is `origin` (all coordinates become p - origin). Keeps digits near
/// it.
Generator seen_from(const Generator& generator, const Vector& origin);

}  // namespace dini
