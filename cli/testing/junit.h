#pragma once

#include <string>
#include <vector>

#include "cli/testing/case_result.h"

namespace dini::cli {

/// The results as JUnit XML, as Jenkins, GitLab and others read it: a suite for each graph, a failure for what ends
/// with 1 (a check, a golden result), an error for all else.
std::string junit_of(const std::vector<CaseResult>& results);

}  // namespace dini::cli
