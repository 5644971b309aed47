#pragma once

#include <string>
#include <vector>

#include "cli/testing/case_result.h"

namespace dini::cli {

/// When and where tests were run.
struct TestRun {
  std::string begun;  ///< UTC, as 2026-01-31T12:00:00
  std::string host;
};

/// The run that begins now, on this machine.
TestRun test_run_of_now();

/// The results as JUnit XML, as Jenkins, GitLab and others read it: a suite for each graph with its warnings as its
/// standard error, a failure for what ends with 1 (a check, a golden result), an error for all else.
std::string junit_of(const std::vector<CaseResult>& results, const TestRun& run);

}  // namespace dini::cli
