#pragma once

#include "geometry/axis.h"

namespace dini {

/// Stands, in a rule for the axes that a node makes, for the axes that it consumes: of a node that sees all values
/// along an axis at once, and gives one for each of them again. Such an axis keeps its name, its size and its closure.
inline Axis kept_axes() { return {"", 0, false}; }

inline bool is_kept_axes(const Axis& axis) { return axis.name.empty() && axis.size == 0; }

}  // namespace dini
