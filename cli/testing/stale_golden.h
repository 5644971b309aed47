#pragma once

#include <string>
#include <vector>

#include "cli/testing/case_result.h"
#include "cli/testing/run_case.h"

namespace dini::cli {

/// A failed case for each golden result that no case has any more: of a graph that was tested and has no such case, or,
/// in the folder `golden` beside graphs of a folder that was tested, of no graph at all. `paths` are what the user
/// named. Those of graphs that were not tested, or cannot be read, are left alone, and so are those of unknown graphs
/// in the folder of --golden, for others may use it too.
std::vector<CaseResult> stale_golden(const GoldenOptions& options, const std::vector<TestGraph>& graphs,
                                     const std::vector<std::string>& paths);

}  // namespace dini::cli
