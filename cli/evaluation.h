#pragma once

#include <string>

#include "cli/source_text.h"
#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// What an evaluation came to: its report and the file, or why there is none.
struct Outcome {
  int code = 0;  ///< an `ExitCode`
  Problems problems = {};
  Json report = Json::object();
  SharedFile file = nullptr;
};

Outcome failed(const Problems& problems, int code);

/// Work that is given up after so many milliseconds; 0 is for ever, since nobody waits at the other end of a script.
Job job_within(std::size_t milliseconds);

/// Computes what was prepared, or why it could not be, and reports. What goes wrong that should not is an outcome too,
/// never an exception.
Outcome evaluated(const Engine& engine, const Result<SharedPrepared>& prepared, const Job& job);

/// The same from the request on.
Outcome evaluated(const Engine& engine, const EvaluateRequest& request, const Job& job);

/// JSON as it is written for people and programs: indented, with a line end, and whatever is no UTF-8 replaced.
std::string written(const Json& json);

/// The report of every outcome says whether it is one of success, so that a failed run never leaves one behind that
/// says so.
Json report_of(const Outcome& outcome, const SourceText* source);

/// `out: 1234 bytes, 10 vertices, 12 triangles`
std::string summary_of(const Json& report);

/// A line for each part that a report tells of: `  skin: watertight, 1 piece, ...`.
std::string parts_of(const Json& report);

/// The times of the nodes that ran, a line each, the longest first.
std::string times_of(const Json& report);

}  // namespace dini::cli
