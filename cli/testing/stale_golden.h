#pragma once

#include <string>
#include <vector>

#include "cli/testing/case_result.h"
#include "cli/testing/run_case.h"

namespace dini::cli {

/// A failed case for each golden result that no case has any more: of a graph that was tested and has no such case, or
/// of no graph at all, in the folder `golden` beside graphs of a folder that was tested, or in that of --golden where
/// whole folders were tested. `paths` are what the user named. Those of graphs that were not tested, or cannot be read,
/// are left alone.
std::vector<CaseResult> stale_golden(const GoldenOptions& options, const std::vector<TestGraph>& graphs,
                                     const std::vector<std::string>& paths);

}  // namespace dini::cli
