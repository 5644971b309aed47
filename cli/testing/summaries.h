#pragma once

#include <string>
#include <vector>

#include "cli/testing/case_result.h"

namespace dini::cli {

/// The results as JSON: `succeeded`, the numbers of what passed and failed, and each case with its errors and outputs.
Json test_report_of(const std::vector<CaseResult>& results);

/// The results as a Markdown page for the summary of a job: a table of cases, and what is wrong below it.
std::string test_page_of(const std::vector<CaseResult>& results);

/// The line of one case in the table on a terminal: `passed   ring.json: wide    12 ms  4321 bytes  same`.
std::string table_line(const CaseResult& result, std::size_t title_width, bool colored);

}  // namespace dini::cli
