#pragma once

#include "geometry/cancel.h"

namespace dini::support {

/// For what takes a Cancel, where the test stops nothing.
inline const Cancel never_stopped;

}  // namespace dini::support
