#pragma once

#include "tests/support/toy_nodes.h"

namespace dini::support {

/// The toys, registered once for all tests of the program.
inline const Registry toy_registry = toy::registry();

}  // namespace dini::support
