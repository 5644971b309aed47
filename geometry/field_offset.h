#pragma once

#include "geometry/scalar_field.h"

namespace dini {

/// The solid grown by `distance` on all sides, or shrunk where it is negative: the value minus the distance.
SharedField offset_field(SharedField field, double distance);

/// The wall of a `thickness` along the surface: between `inside` below it and thickness - `inside` above it.
SharedField shell_field(SharedField field, double thickness, double inside);

}  // namespace dini
