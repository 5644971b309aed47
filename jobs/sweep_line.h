#pragma once

#include <string>

#include "jobs/variant_outcome.h"
#include "store/job_store.h"

namespace dini::jobs {

/// What came of a variant of a sweep: JSON in one line, and its files, whose addresses the line tells; all addresses
/// begin with `base_path`.
store::JobLine sweep_line(const Engine& engine, const VariantOutcome& outcome, const std::string& base_path);

/// The line of a variant that nothing came of.
store::JobLine failed_line(std::size_t index, const Json& setting, const Problems& problems);

/// Where a file that was made can be fetched.
std::string artifact_address(const File& file, std::string_view base_path);

}  // namespace dini::jobs
