#pragma once

#include <vector>

#include "cli/testing/case_result.h"

namespace dini::cli {

/// All problems and warnings as SARIF 2.1.0, as GitHub and editors read it: a rule for each code, a result for each
/// problem, in its file, line and column.
Json sarif_of(const std::vector<CaseResult>& results);

}  // namespace dini::cli
