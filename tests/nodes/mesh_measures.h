#pragma once

#include <catch2/catch.hpp>

#include "geometry/measure.h"
#include "geometry/validate.h"
#include "tests/support/never_stopped.h"

namespace dini::support {

/// The measures of a mesh, which must keep its promises.
inline Measures measures_of(const Mesh& mesh) {
  CHECK_FALSE(mesh_defect(mesh));
  return measure(mesh, never_stopped);
}

}  // namespace dini::support
