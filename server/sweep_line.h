#pragma once

#include <string>

#include "jobs/sweep.h"
#include "server/application.h"

namespace dini::server {

/// What came of a variant of a sweep, as JSON in one line. Its file can be fetched by the address that the line tells.
std::string sweep_line(Application& application, const jobs::VariantOutcome& outcome);

}  // namespace dini::server
