#pragma once

#include "geometry/cancel.h"
#include "graph/problem.h"

namespace dini {

/// What is said about work that was stopped: `deadline`, `superseded`, `client-gone`, `canceled` or `shutting-down`.
Problem stopped_problem(StopReason reason);

/// What is said when memory ran out: `out-of-memory`. The same request may well succeed later.
Problem out_of_memory();

}  // namespace dini
