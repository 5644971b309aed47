#pragma once

// Changing the origin.

#include "algebra/elements.h"

namespace dini {

/// The same generator in coordinates whose origin is `origin` (all coordinates become p - origin). Keeps digits near
/// it.
Generator seen_from(const Generator& generator, const Vector& origin);

/// A good origin for products with a bivector: the middle of a pair or circle that lies off the origin, else the origin
/// itself. From elsewhere they lose digits with the cube of the distance over the size.
Vector middle(const Generator& generator);

}  // namespace dini
