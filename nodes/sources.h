#pragma once

#include <vector>

#include "algebra/kernels.h"
#include "graph/lift.h"

namespace dini {

/// The generators of a field that act, each with its position; a zero generator does nothing wherever it sits. One that
/// sits nowhere (a pure direction) is a failure, for no distance to it can be measured. Stopped early: only the first.
Attempt<std::vector<kernels::WarpSource>> sources_of(const Context& context, const Block<Generator, 1>& generators);

}  // namespace dini
