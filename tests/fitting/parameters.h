#pragma once

#include "geometry/json.h"

namespace dini::support {

/// A parameter of a graph that is a number between two others.
inline Json number(double value, double least, double most) {
  return {{"type", "number"}, {"default", value}, {"min", least}, {"max", most}};
}

}  // namespace dini::support
