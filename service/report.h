#pragma once

#include "graph/check.h"
#include "graph/evaluate.h"
#include "service/prepared.h"

namespace dini {

/// What every file says about itself: engine, content hash of the graph, and the parameters that shaped it.
Json file_extras(const Plan& plan, std::size_t output);

/// The files of an answer; null where there is none.
struct AnswerFiles {
  const Asset* model = nullptr;  ///< as the export node made it
  const std::string* glb = nullptr;
  const std::string* preview = nullptr;
};

/// The report of an evaluation: times, what was cached, types and axes, the file, checks and warnings; see
/// docs/http.md.
Json evaluation_report(const Prepared& prepared, const Evaluation& evaluation, const AnswerFiles& files,
                       const std::map<std::string, double>& milliseconds);

/// The answer of a validation: whether the graph is well, its problems, its wires and its cost.
Json validation_report(const CheckReport& report, const Problems& problems);

}  // namespace dini
