#pragma once

// What a runner of jobs knows of those that it does.

#include "jobs/job_runner.h"

namespace dini::jobs {

/// How a job ended.
struct JobRunner::Ending {
  std::string state;
  std::string errors = "[]";
  store::JobResult result = {};
};

/// A job that was begun and has not ended.
struct JobRunner::Live {
  std::shared_ptr<Flights::Interest> interest;
  std::shared_ptr<Sweep> sweep;
  bool canceling = false;
  double progress = 0;
  Json best = nullptr;           ///< what a fit has found so far
  std::optional<Ending> ending;  ///< what could not be written yet
};

}  // namespace dini::jobs
