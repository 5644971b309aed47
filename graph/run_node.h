#pragma once

#include <functional>

#include "graph/context.h"
#include "graph/plan.h"
#include "graph/problem.h"

namespace dini {

/// Gives the column of a source that has been computed.
using ColumnOf = std::function<const AnyColumn&(const Source&)>;

/// Runs one planned node: gathers its arguments, holds wired numbers against the hard ranges, runs its function, and
/// refuses results that are not finite: one column per output. The problem names node, port and sample. Warnings stay
/// with the context.
Result<std::vector<AnyColumn>> run_node(const PlannedNode& node, const ColumnOf& column_of, const Context& context);

}  // namespace dini
