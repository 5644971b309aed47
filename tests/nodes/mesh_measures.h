#pragma once

#include <catch2/catch.hpp>

#include "geometry/measure.h"
#include "geometry/validate.h"

namespace dini::support {

/// The measures of a mesh, which must keep its promises.
inline Measures measures_of(const Mesh& mesh) {
  const Cancel cancel;
  CHECK_FALSE(mesh_defect(mesh));
  return measure(mesh, cancel);
}

}  // namespace dini::support
