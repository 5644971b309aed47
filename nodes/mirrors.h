#pragma once

#include <optional>

#include "algebra/reflection.h"
#include "graph/context.h"

namespace dini {

/// Why a plane or a sphere cannot be a mirror; nothing when it can.
inline std::optional<Failure> fault_of_mirror(const Sphere& mirror) {
  if (is_mirror(mirror)) return std::nullopt;
  return Failure{"degenerate", "the mirror must be a plane, or a sphere with a radius", "mirror"};
}

}  // namespace dini
