#pragma once

#include "graph/job.h"
#include "jobs/sweep_request.h"

namespace dini::jobs {

/// Evaluates all variants, as many at once as there are threads, and puts their models into one GLB: see
/// service/variant_file.h. One variant that fails is a problem of all, with its number.
Result<SharedFile> sweep_file(const Engine& engine, const SweepRequest& request, const Job& job);

}  // namespace dini::jobs
